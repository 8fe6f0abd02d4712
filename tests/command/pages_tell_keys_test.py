# Law: the tables of docs/reference/scene_format.md have every key of the JSON Schema of scenes, and
# every key there has an example in valid JSON.
import json
import pathlib
import re
import subprocess
import sys


def keys_of(schema):
    """The names of all properties, at any depth."""
    if isinstance(schema, dict):
        if isinstance(schema.get("properties"), dict):
            yield from schema["properties"]
        for part in schema.values():
            yield from keys_of(part)
    elif isinstance(schema, list):
        for part in schema:
            yield from keys_of(part)


def examples_of(cell):
    """The JSON texts of a cell; `...` stands for further entries."""
    return [text.replace(", ...", "") for text in re.findall(r"`([^`]+)`", cell)]


def is_json(text):
    try:
        json.loads(text)
    except ValueError:
        return False
    return True


def main(command, page):
    printed = subprocess.run([command, "schema"], capture_output=True, text=True, check=True).stdout
    keys = set(keys_of(json.loads(printed)))
    section = re.search(r"^## Keys\n(.*?)^### Coordinates", pathlib.Path(page).read_text(), re.M | re.S)
    rows = [[cell.strip() for cell in re.split(r"(?<!\\)\|", row)[1:-1]]
            for row in re.findall(r"^\|.*\|$", section[1], re.M)]
    tables = [row for row in rows if len(row) == 3 and row[0] != "key" and set(row[0]) != {"-"}]
    told = set()
    failures = []
    for key, example, _ in tables:
        # The table of distances tells places, not keys.
        if key.startswith(("the second", "a further", "point")):
            continue
        told |= set(re.findall(r"\w+", " ".join(re.findall(r"`([^`]+)`", key + example))))
        if not examples_of(example):
            failures.append(f"{key}: there is no example")
        failures += [f"{key}: {text} is not JSON" for text in examples_of(example) if not is_json(text)]
    failures += [f"no table has the key {key}" for key in sorted(keys - told)]
    print(*failures, f"{len(keys)} keys, {len(tables)} rows, {len(failures)} failures", sep="\n")
    return 1 if failures or len(tables) < 30 else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
