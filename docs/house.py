"""Turns the build's own targets into the tables of the house in design.md: each folder with its
floor, what it turns into what, by the first comment of its CMakeLists.txt, and what it links.

house.py TARGETS SOURCE [--write]: TARGETS has a line per target, its name, its folder and the
targets that it links, separated by tabs; SOURCE is the project. Without --write it compares."""
import pathlib
import re
import sys

DOORS = [("generator", "generator/"), ("mechanism", "mechanism/src/")]


def read_targets(file):
    """Folders with the folders that they link. A folder may have several targets."""
    rows = [line.split("\t") for line in pathlib.Path(file).read_text().splitlines()]
    folder_of = {name: folder for name, folder, _ in rows}
    links = {folder: set() for folder in folder_of.values()}
    for _, folder, linked in rows:
        for name in linked.split(";"):
            other = folder_of.get(name.replace("::", "_"))
            if other not in (None, folder):
                links[folder].add(other)
    return links


def floors(links):
    """The longest way down from each folder: arrows that go in a circle have none."""
    known = {}

    def floor(folder, above=()):
        if folder in above:
            raise SystemExit(f"the folders {', '.join(above)} link one another in a circle")
        if folder not in known:
            known[folder] = 1 + max((floor(below, (*above, folder)) for below in links[folder]),
                                    default=-1)
        return known[folder]

    for folder in links:
        floor(folder)
    return known


def below(links, folders):
    """What these folders link, directly or through others: it need not be told again."""
    linked = {other for one in folders for other in links[one]}
    return linked | below(links, linked) if linked else linked


def sentence(source, folder):
    """The first paragraph of comment of a folder's CMakeLists.txt, without its 'Turns'."""
    text = (source / folder / "CMakeLists.txt").read_text()
    comment = " ".join(re.match(r"((?:# .*\n)+|)", text)[1].replace("# ", "").split("\n")).strip()
    found = re.match(r"Turns (.+?)\.(?: |$)", comment)
    if not found:
        raise SystemExit(f"{folder}/CMakeLists.txt does not begin with '# Turns ... into ...'")
    return found[1]


def tables(links, source):
    floor_of = floors(links)
    for door, prefix in DOORS:
        rows = sorted((folder for folder in links if folder.startswith(prefix)),
                      key=lambda folder: (-floor_of[folder], folder))
        lowest = min(floor_of[folder] for folder in rows)
        yield f"| floor | `{prefix}` | turns | links |"
        yield "|---|---|---|---|"
        for folder in rows:
            nearest = sorted(links[folder] - below(links, links[folder]))
            names = ", ".join("`" + one.removeprefix(prefix) + "`" for one in nearest)
            yield (f"| {floor_of[folder] - lowest} | `{folder.removeprefix(prefix)}` | "
                   f"{sentence(source, folder)} | {names} |")
        if door == DOORS[0][0]:
            yield ""


def main(targets, source, *options):
    source = pathlib.Path(source)
    page = source / "docs/method/design.md"
    text = page.read_text()
    drawn = "\n".join(tables(read_targets(targets), source))
    begin, end = "<!-- house -->\n", "\n<!-- end of house -->"
    head, _, rest = text.partition(begin)
    stands, _, tail = rest.partition(end)
    if options == ("--write",):
        page.write_text(head + begin + drawn + end + tail)
        return 0
    if stands != drawn:
        print("docs/method/design.md is not what the build's targets say; build the target 'house'")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
