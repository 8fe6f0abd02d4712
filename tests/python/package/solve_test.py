"""Law: a solution holds every number of `assur solve --format json`, and no other."""

import numpy as np
import pytest
from numpy.testing import assert_array_equal

import assur

COVARIANCE = {"parameters": ["crank", "coupler"],
              "matrix": [[4e-4, 1e-4], [1e-4, 9e-4]]}
SCENES = ["four_bar_coupler_curve", "excavator_arm", "scissor_lift", "slider_crank",
          "quintero_2011_rrp_rrr", "gripper"]
ABSENT = object()


def told(state, name):
    """A number of a state; ABSENT where the scene does not want it."""
    try:
        return getattr(state, name)
    except assur.NotWanted:
        return ABSENT


def expect_equal(found, printed, name):
    if printed is ABSENT or found is ABSENT:
        assert printed is found, name
    else:
        assert_array_equal(np.asarray(found), np.asarray(printed, dtype=float), name)


def expect_parts(states, printed, parameters):
    assert list(states.links) == list(printed["links"])
    for name, link in printed["links"].items():
        pose = [link["x"], link["y"], link["theta"]] if "x" in link else ABSENT
        expect_equal(told(states.links[name], "pose"), pose, name)
        for rate in ("velocity", "acceleration"):
            expect_equal(told(states.links[name], rate), link.get(rate, ABSENT), name)
    assert sorted(states.joints) == sorted(printed["joints"])
    for name, slide in printed["joints"].items():
        for number in ("displacement", "velocity", "acceleration"):
            expect_equal(told(states.joints[name], number), slide.get(number, ABSENT), name)
    assert list(states.outputs) == list(printed["outputs"])
    for name, point in printed["outputs"].items():
        for number in ("position", "velocity", "acceleration", "tangential", "normal", "worst_case",
                       "rss", "covariance", "mean_shift"):
            expect_equal(told(states.outputs[name], number), point.get(number, ABSENT),
                         name + "." + number)
        sensitivity = ABSENT
        if "sensitivity" in point:
            assert tuple(point["sensitivity"]) == parameters
            sensitivity = np.array(list(point["sensitivity"].values()), dtype=float)
            sensitivity = sensitivity.reshape(-1, 2).T
        expect_equal(told(states.outputs[name], "sensitivity"), sensitivity, name)


def expect_solution(solution, printed, parameters):
    assert solution.status.word == printed["status"] == str(solution.status)
    assert solution.mobility == printed["mobility"]
    assert solution.reason == printed.get("reason", "")
    if "left_out" in printed:
        assert solution.left_out == printed["left_out"]
    assert len(solution) == len(printed["configurations"])
    for place, configuration in enumerate(printed["configurations"]):
        one = solution[place]
        assert one.number == place + 1
        expect_parts(one, configuration, parameters)
        assert one.residual == configuration["residual"] == solution.residual[place]
        assert one.regular == (configuration["regularity"] == "regular") == solution.regular[place]
        branches = configuration.get("branches", [])
        assert (one.branches is None) == (not branches)
        for number, branch in enumerate(branches):
            for name, link in branch["links"].items():
                for rate in ("velocity", "acceleration"):
                    assert_array_equal(getattr(one.branches.links[name], rate)[number], link[rate])
            for name, point in branch["outputs"].items():
                assert_array_equal(one.branches.outputs[name].velocity[number], point["velocity"])
    assert len(solution.families) == len(printed.get("families", []))
    for family, expected in zip(solution.families, printed.get("families", [])):
        assert (family.group, family.mobility, family.reason) == (
            expected["group"], expected["mobility"], expected["reason"])
        assert set(family.links) == set(expected["after"]["links"])
        for name, link in expected["after"]["links"].items():
            assert_array_equal(family.links[name], [link["x"], link["y"], link["theta"]])


def expect_as_command(command, scene):
    planned = assur.Plan(assur.parse_scene(scene))
    printed = command.json(scene)
    solution = planned.solve()
    expect_solution(solution, printed, planned.parameters)
    groups = [{"class": group.assur_class, "kind": group.kind, "model": group.model,
               "links": group.links, "joints": group.joints} | (
                   {"complex_configurations": group.complex_configurations}
                   if group.complex_configurations else {}) | (
                   {"relative_to": group.relative_to} if group.relative_to else {})
              for group in planned.groups]
    assert groups == printed["groups"]
    assert list(planned.redundant) == printed.get("redundant", [])
    return solution


@pytest.mark.parametrize("name", SCENES)
def test_examples(command, example, name):
    solution = expect_as_command(command, example(name))
    assert len(solution) > 0


def test_a_crossing_has_its_motions(command, parallelogram):
    solution = expect_as_command(command, parallelogram)
    crossing = [one for one in solution if one.branches is not None]
    assert len(crossing) == 1
    assert np.isnan(crossing[0].outputs["P"].velocity).all()
    rates = crossing[0].branches.links["rocker"].velocity
    assert rates.shape == (2, 3)
    # The bars 2 and 5 turn with the crank, or against it as (5 + 2) : (5 - 2).
    np.testing.assert_allclose(sorted(rates[:, 2]), [-2 * 7 / 3, 2], rtol=1e-12)


def test_a_family_alone(command, parallelogram):
    # The crank's end lies on the rocker's pivot, and the bars between them are equal.
    parallelogram["links"]["ground"]["D"] = ["a", 0]
    parallelogram["links"]["coupler"]["C"] = ["a", 0]
    solution = expect_as_command(command, parallelogram)
    assert solution.status == assur.Status.DEGENERATE
    assert solution.families and solution.links["crank"].pose.shape == (0, 3)


def test_covariance_and_second_derivatives(command, example):
    scene = example("four_bar_coupler_curve", covariance=COVARIANCE)
    solution = expect_as_command(command, scene)
    point = solution[0].outputs["P"]
    names = list(solution.parameters)
    step = 1e-4
    here = names.index("phi")
    plan = assur.Plan(assur.parse_scene(scene))
    ahead, behind = (plan.solve(phi=solution.parameters["phi"] + by)[0].outputs["P"].sensitivity
                     for by in (step, -step))
    assert point.hessian.shape == (2, len(names), len(names))
    assert_array_equal(point.hessian, point.hessian.transpose(0, 2, 1))
    np.testing.assert_allclose(point.hessian[:, :, here], (ahead - behind) / (2 * step),
                               rtol=1e-6, atol=1e-5)


@pytest.mark.parametrize("want", [["position"], ["velocity"], ["acceleration", "sensitivity"], []])
def test_nothing_that_is_not_wanted(command, example, want):
    expect_as_command(command, example("slider_crank", want=want))


def test_reported_parts(command, example):
    expect_as_command(command, example("jansen_leg", report={"links": ["lower"], "joints": []}))


def test_constraints_that_are_too_many(command, parallelogram):
    parallelogram["parameters"]["phi"] = 0.7
    parallelogram["links"]["strut"] = {"E": [0, 0], "F": ["a", 0]}
    parallelogram["links"]["ground"]["E"] = ["b/2", 0]
    parallelogram["links"]["coupler"]["F"] = ["b/2", 0]
    parallelogram["joints"]["E"] = {"type": "revolute", "between": ["ground.E", "strut.E"]}
    parallelogram["joints"]["F"] = {"type": "revolute", "between": ["coupler.F", "strut.F"]}
    solution = expect_as_command(command, parallelogram)
    assert len(solution) > 0 and len(solution[0].joints) == 0


def test_values_by_keyword_and_mapping(command, example):
    scene = example("watt_six_bar")
    plan = assur.Plan(assur.parse_scene(scene))
    printed = command.json(scene, "--set", "phi=1.25", "--set", "EF=101")
    for solution in (plan.solve(phi=1.25, EF=101), plan.solve({"phi": 1.25, "EF": 101}),
                     plan.solve({"phi": 7, "EF": np.int64(101)}, phi=np.float32(1.25)),
                     assur.Plan(assur.parse_scene(scene, EF="50*2 + 1"))
                     .solve({"phi": np.array(1.25)}),
                     assur.Plan(assur.parse_scene(scene, {"phi": 1.25}, EF=101)).solve()):
        expect_solution(solution, printed, plan.parameters)
        assert solution.parameters["EF"] == 101


def test_what_was_solved_before_changes_nothing(example):
    plan = assur.Plan(assur.parse_scene(example("excavator_arm")))
    fresh = assur.Plan(assur.parse_scene(example("excavator_arm"))).solve(t=0.4)
    plan.solve(t=0.1)
    plan.solve(boom_length=5.6)
    with pytest.raises(assur.SceneError):
        plan.solve(t=float("nan"))
    plan.solve(t=0.2)
    again = plan.solve(t=0.4)
    for name in again.links:
        for number in ("pose", "velocity", "acceleration", "sensitivity"):
            assert_array_equal(getattr(again.links[name], number),
                               getattr(fresh.links[name], number))


def test_names_that_are_words_of_python(example):
    scene = example("slider_crank")
    scene["parameters"].update({"values": 1, "number": 2, "self": 3, "lambda": 4})
    plan = assur.Plan(assur.parse_scene(scene, values=10, number=20))
    assert plan.solve(values=5, number=6).parameters["values"] == 5
    given = {"self": 7, "lambda": 8}  # as keywords these two are words of Python
    solved = plan.solve_one(1, given, values=9).parameters
    assert (solved["self"], solved["lambda"], solved["values"], solved["number"]) == (7, 8, 9, 20)


def test_a_scene_without_parameters(command, example):
    scene = {"links": {"ground": {"A": [0, 0]}, "arm": {"A": [0, 0], "B": [2, 0]}},
             "joints": {"A": {"type": "revolute", "between": ["ground.A", "arm.A"]}},
             "drivers": {"A": {"position": 0.5, "velocity": 1}}, "outputs": {"B": "arm.B"}}
    solution = expect_as_command(command, scene)
    assert solution.outputs["B"].sensitivity.shape == (1, 2, 0)
    scene["outputs"] = {}
    assert len(expect_as_command(command, scene).outputs) == 0


def test_what_depends_on_a_parameter_follows_it(command, example):
    scene = example("four_bar_coupler_curve",
                    covariance={"parameters": ["crank"], "matrix": [["phi^2 * 1e-4"]]})
    scene["parameters"].update(crank={"value": 40, "tolerance": "0.01*phi + 0.001*coupler"},
                               half="coupler/2")
    scene["joints"]["D"]["limits"] = ["-2*phi", "2*phi"]
    plan = assur.Plan(assur.parse_scene(scene))
    for values in ({"phi": 0.2}, {"phi": 2.2}, {"phi": 1.4}, {"phi": 1.4, "coupler": 90}):
        settings = [f"--set={name}={value}" for name, value in values.items()]
        expect_solution(plan.solve(values), command.json(scene, *settings), plan.parameters)


def test_one_and_nearest(command, example):
    scene = example("gripper")
    plan = assur.Plan(assur.parse_scene(scene))
    printed = command.json(scene, "--nearest")
    every = plan.solve()
    assert every.nearest.place + 1 == printed["nearest"]["configuration"]
    alone = plan.solve_nearest()
    assert len(alone) == 1 and alone[0].number is None
    for nearest in (every.nearest, alone.nearest):
        assert nearest.distance == pytest.approx(printed["nearest"]["distance"], rel=1e-12)
        assert nearest.runner_up == pytest.approx(printed["nearest"]["runner_up"], rel=1e-12)
    expect_parts(alone[0], printed["configurations"][0], plan.parameters)
    third = plan.solve_one(3)
    assert len(third) == 1 and third[0].number == 3
    for name, point in third[0].outputs.items():
        assert_array_equal(point.position, every[2].outputs[name].position)


def test_the_commands_own_reports(command, example):
    scene = example("watt_six_bar")
    solution = assur.Plan(assur.parse_scene(scene)).solve(EF=20, FG=20)
    file = command.file(scene)
    shown = ["solve", file, "--set", "EF=20", "--set", "FG=20"]
    assert solution.to_json() == command.run(*shown, "--format", "json").stdout
    assert str(solution) == command.run(*shown).stdout
    assert solution.status == assur.Status.NO_ASSEMBLY
    assert "fail to close by 45.3" in solution.reason
