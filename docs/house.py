"""Writes the house into design.md, a drawing and tables of the build's own targets: each folder
with its floor, its contents, by the first sentence of its CMakeLists.txt, and the folders that it
links.

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
    """The first sentence of a folder's CMakeLists.txt, a comment."""
    text = (source / folder / "CMakeLists.txt").read_text()
    comment = " ".join(re.match(r"((?:# .*\n)+|)", text)[1].replace("# ", "").split("\n")).strip()
    found = re.match(r"(.+?)\.(?: |$)", comment)
    if not found:
        raise SystemExit(f"{folder}/CMakeLists.txt does not begin with a sentence in a comment")
    return found[1]


def rooms(links, prefix):
    """The folders behind a door, with their floors above its lowest: the highest first."""
    floor_of = floors(links)
    folders = [folder for folder in links if folder.startswith(prefix)]
    lowest = min(floor_of[folder] for folder in folders)
    return sorted(((floor_of[folder] - lowest, folder) for folder in folders),
                  key=lambda room: (-room[0], room[1]))


def drawing(links):
    columns = []
    for door, prefix in DOORS:
        storeys = {}
        for floor, folder in rooms(links, prefix):
            storeys.setdefault(floor, []).append(folder.removeprefix(prefix))
        columns.append((door, storeys))
    (left, first), (right, second) = columns
    names = {floor: "   ".join(first.get(floor, [])) for floor in range(max(first) + 1)}
    width = max(map(len, names.values())) + 6
    yield "```"
    yield f"floor   {left:<{width}}{right}".rstrip()
    for floor in range(max(names), -1, -1):
        yield f"{floor:>5}   {names[floor]:<{width}}{'   '.join(second.get(floor, []))}".rstrip()
    yield "```"
    yield ""


def tables(links, source):
    for door, prefix in DOORS:
        yield f"| floor | `{prefix}` | contents | links |"
        yield "|---|---|---|---|"
        for floor, folder in rooms(links, prefix):
            nearest = sorted(links[folder] - below(links, links[folder]))
            names = ", ".join("`" + one.removeprefix(prefix) + "`" for one in nearest)
            yield (f"| {floor} | `{folder.removeprefix(prefix)}` | "
                   f"{sentence(source, folder)} | {names} |")
        if door == DOORS[0][0]:
            yield ""


def main(targets, source, *options):
    source = pathlib.Path(source)
    page = source / "docs/method/design.md"
    text = page.read_text()
    links = read_targets(targets)
    drawn = "\n".join([*drawing(links), *tables(links, source)])
    begin, end = "<!-- house -->\n", "\n<!-- end of house -->"
    if text.count(begin) != 1 or text.count(end) != 1:
        raise SystemExit(f"{page}: the house stands between two comments, once each")
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
