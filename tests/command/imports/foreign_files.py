"""Writes files of other programs: what Linkage, PMKS+ and Pyslvs would write for given parts."""

DIGITS = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_-"


def linkage(connectors, links, ratios=(), program='units="Millimeters" scalefactor="1"', more=""):
    """Each part is (attributes, children); a child is a tag with its identifier."""
    def element(tag, attributes, children):
        inside = "".join(f'<{child} id="{number}"/>' for child, number in children)
        return f"<{tag} {attributes}>{inside}</{tag}>\n"

    text = f"<linkage2>\n<program {program}/>\n"
    text += "".join(element("connector", *connector) for connector in connectors)
    text += "".join(element("Link", *link) for link in links)
    if ratios:
        text += "<ratios>"
        for kind, (one, size_one), (other, size_other) in ratios:
            text += (f'<ratio type="{kind}"><link id="{one}" size="{size_one}"/>'
                     f'<link id="{other}" size="{size_other}"/></ratio>')
        text += "</ratios>\n"
    return text + more + "</linkage2>\n"


def pin(number, x, y, attributes="", children=()):
    return f'id="{number}" x="{x}" y="{y}" {attributes}', children


def bar(number, connectors, attributes="", fastened=()):
    children = [("connector", each) for each in connectors]
    return f'id="{number}" {attributes}', children + [("fastenconnector", each) for each in fastened]


def whole(number):
    number = round(number)
    sign, number, text = ("0" if number < 0 else ""), abs(number), ""
    while True:
        text, number = DIGITS[number % 64] + text, number // 64
        if number == 0:
            return sign + text


def thousandths(number):
    return whole(number * 1000)


def joint(flags, name, x, y, angle=0, title=None, *, slot=(), speed=None, mass=None):
    fields = [name if title is None else title, thousandths(x), thousandths(y), thousandths(angle)]
    if slot or speed is not None or mass is not None:
        fields += list(slot) or ["", "", ""]
        fields += [thousandths(speed or 0)] + ([thousandths(mass)] if mass is not None else [])
    return DIGITS[flags] + name + "," + ",".join(fields)


def link(name, joints, title=None, mass=0, inertia=0, center=(0, 0), parts=(), head="YR"):
    numbers = ",".join(map(thousandths, (mass, inertia, *center)))
    return (f"{head}{name},{name if title is None else title},{numbers},c5cae9,"
            f"{','.join(joints)},,{','.join(parts)}")


def force(flags, name, on, start, end, magnitude):
    numbers = ",".join(map(thousandths, (*start, *end, magnitude)))
    return f"{DIGITS[flags]}{name},{on},{name},{numbers}"


def payload(joints, links, forces=(), *, flags=0, rpm=10, slide=None, unit="1", tail=None,
            digest=False):
    decimals = thousandths(1) + ("" if slide is None else "," + thousandths(slide))
    text = f"{DIGITS[flags // 64]}{DIGITS[flags % 64]}.{decimals}.{whole(rpm)},0.{unit}11."
    for records in (joints, links, forces):
        text += "".join(record + "." for record in records) + "."
    text += "N_" + ("" if tail is None else "." + tail)
    text += DIGITS[len(text) % 62]
    if digest:
        number = 0x811C9DC5
        for letter in text.encode():
            number = (number ^ letter) * 0x01000193 % 2**32
        letters = ""
        for _ in range(6):
            letters, number = DIGITS[number % 62] + letters, number // 62
        text += "*" + letters
    return text
