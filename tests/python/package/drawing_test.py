"""Law: pictures are those of `assur draw`, byte for byte."""

import pytest

import assur


def drawn(command, scene, ending, *more):
    file = command.folder / ("picture" + ending)
    told = command.run("draw", command.file(scene), "--output", file, *more)
    return file.read_text() if told.returncode == 0 else told.stderr


def test_scenes(command, example):
    scene = example("slider_crank", steps=13)
    here = assur.read_scene(command.file(scene))
    assert here.svg() == here._repr_svg_() == drawn(command, scene, ".svg")
    assert here.svg(2) == drawn(command, scene, ".svg", "--configuration", 2)
    assert here.moving_svg(branch=1) == drawn(command, scene, ".svg", "--moving",
                                              "--configuration", 1)
    assert here.dxf(configuration=1) == drawn(command, scene, ".dxf", "--configuration", 1)
    assert here.page() == drawn(command, scene, ".html")
    pages = [here.page(branch) for branch in (1, 2)]
    assert pages == [drawn(command, scene, ".html", "--configuration", one) for one in (1, 2)]
    assert pages[0] != pages[1]
    with pytest.raises(assur.SceneError, match="there is no branch 9"):
        here.page(9)


def test_the_nearest(command, example):
    scene = example("gripper")
    scene.pop("sweep", None)
    here = assur.read_scene(command.file(scene))
    expected = drawn(command, scene, ".svg", "--nearest")
    assert here.svg(nearest=True) == expected == assur.Plan(here).solve_nearest().svg()


def test_solutions_at_other_values(command, example):
    scene = example("four_bar_coupler_curve", steps=13)
    plan = assur.Plan(assur.read_scene(command.file(scene)))
    solution = plan.solve(phi=2.5, crank=38)
    values = ("--set", "phi=2.5", "--set", "crank=38")
    assert solution.svg() == solution._repr_svg_() == drawn(command, scene, ".svg", *values)
    expected = drawn(command, scene, ".svg", "--configuration", 2, *values)
    assert solution[1].svg() == solution[1]._repr_svg_() == expected
    assert plan.solve_one(2, phi=2.5, crank=38).svg() == expected


def test_what_cannot_be_drawn(command, example):
    scene = example("four_bar_coupler_curve", steps=5)
    here = assur.read_scene(command.file(scene), coupler=20, rocker=20)
    with pytest.raises(assur.SceneError) as raised:
        here.svg()
    line = drawn(command, scene, ".svg", "--set", "coupler=20", "--set", "rocker=20")
    assert line == f"error: {raised.value}\n"
    assert here._repr_svg_() is None  # so that a notebook shows the text
    solution = assur.Plan(here).solve()
    assert solution._repr_svg_() is None and "fail to close" in str(solution)
    for call in (lambda: here.svg(7), lambda: here.dxf()):
        with pytest.raises(assur.SceneError, match="scene.json: "):
            call()
