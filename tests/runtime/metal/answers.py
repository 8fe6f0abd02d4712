"""Compares the campaign's answers of a board and of the host, and summarises the board's costs."""

import array
import pathlib

# In the order of campaign_models.hpp.
models = ["dyad RRR", "dyad PRR", "triad RR-RR-RR", "tetrad RRR-RRR", "tetrad PPR-RRP"]


def answers(file):
    """For each group its model; status, count and mobility; instructions; bytes; configurations."""
    numbers = array.array("d")
    numbers.frombytes(pathlib.Path(file).read_bytes())
    at = 0
    while at < len(numbers):
        model, status, count, mobility, instructions, stack, size = map(int, numbers[at:at + 7])
        at += 7
        end = at + count * size
        yield model, (status, count, mobility), instructions, stack, numbers[at:end]
        at = end


def compared(host_file, target_file, groups, special):
    """The first `special` groups are in special position. Largest: the largest difference between
    numbers that are not the same bit for bit."""
    host, target = list(answers(host_file)), list(answers(target_file))
    if len(host) != groups or len(target) != groups:
        raise SystemExit(f"{len(target)} answers of the machine, {len(host)} of the host, to "
                         f"{groups} groups")
    result = {"groups": groups, "configurations": 0, "lost": 0, "invented": 0, "other_verdicts": 0,
              "unlike": 0, "largest": 0.0,
              "models": {model: {"groups": 0, "configurations": 0, "general": 0, "special": 0,
                                 "stack": 0} for model in models}}
    for number, (ours, theirs) in enumerate(zip(host, target)):
        of_model = result["models"][models[ours[0]]]
        of_model["groups"] += 1
        of_model["configurations"] += ours[1][1]
        position = "special" if number < special else "general"
        of_model[position] = max(of_model[position], theirs[2])
        of_model["stack"] = max(of_model["stack"], theirs[3])
        result["configurations"] += ours[1][1]
        result["lost"] += max(0, ours[1][1] - theirs[1][1])
        result["invented"] += max(0, theirs[1][1] - ours[1][1])
        result["other_verdicts"] += ours[1] != theirs[1]
        if ours[1] == theirs[1] and ours[4].tobytes() != theirs[4].tobytes():
            result["unlike"] += 1
            difference = max(abs(one - other) for one, other in zip(ours[4], theirs[4]))
            result["largest"] = max(result["largest"], difference)
    return result
