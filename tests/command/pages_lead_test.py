# Law: every link on a page leads to an existing file, and to one of its headings if it names one;
# docs/README.md leads to every page below docs; and pages that sources name exist.
import pathlib
import re
import sys

LINK = re.compile(r"\]\(([^)\s]+)\)")
FENCE = re.compile(r"^```.*?^```", re.M | re.S)
SOURCES = ("bench", "cmake", "examples", "generator", "mechanism", "packaging", "python", "runtime",
           "templates", "tests")
SUFFIXES = (".cpp", ".hpp", ".txt", ".cmake", ".mustache", ".py", ".gp", ".gnuplot", ".audit")


def anchors(page):
    """The names that headings have in a browser: small letters, hyphens between words."""
    headings = re.findall(r"^#+ (.*)", FENCE.sub("", page.read_text()), re.M)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


def links(page):
    text = re.sub(r"`[^`\n]*`", "", FENCE.sub("", page.read_text()))
    return [link for link in LINK.findall(text) if "://" not in link]


def main(root):
    root = pathlib.Path(root)
    docs = sorted((root / "docs").rglob("*.md"))
    pages = [*sorted(root.glob("*.md")), *docs]
    failures, count = [], 0
    for page in pages:
        for link in links(page):
            count += 1
            name, _, anchor = link.partition("#")
            target = (page.parent / name).resolve() if name else page
            if not target.exists():
                failures.append(f"{page.relative_to(root)}: no file {link}")
            elif anchor and anchor not in anchors(target):
                failures.append(f"{page.relative_to(root)}: no heading {link}")
    sources = (file for folder in SOURCES for file in (root / folder).rglob("*")
               if file.suffix in SUFFIXES)
    for source in sources:
        for page in re.findall(r"\bdocs/[\w/]+\.(?:md|svg)\b", source.read_text()):
            count += 1
            if not (root / page).exists():
                failures.append(f"{source.relative_to(root)}: no file {page}")
    index = root / "docs/README.md"
    told = {(index.parent / link.partition("#")[0]).resolve() for link in links(index)}
    failures += [f"docs/README.md does not lead to {page.relative_to(root)}"
                 for page in docs if page != index and page.resolve() not in told]
    print(*failures, f"{len(pages)} pages, {count} links, {len(failures)} failures", sep="\n")
    return 1 if failures or not count else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
