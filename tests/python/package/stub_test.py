"""Law: the stub file has the names and signatures of the package, and each has a docstring."""

import ast
import enum
import inspect
import pathlib

import assur

STUB = ast.parse((pathlib.Path(assur.__file__).parent / "__init__.pyi").read_text())
NAMED = {"__getitem__", "__len__", "__iter__", "__contains__", "__init__"}
EXCEPTION = set(dir(Exception))


def stub_classes():
    return {node.name: node for node in STUB.body if isinstance(node, ast.ClassDef)}


def stub_functions(body):
    return {node.name: node for node in body if isinstance(node, ast.FunctionDef)}


def parameters_of(node):
    """Names, whether each may be given by name, and the defaults of a stub's function."""
    names = [(one.arg, "positional") for one in node.args.posonlyargs]
    names += [(one.arg, "either") for one in node.args.args]
    defaults = [ast.literal_eval(one) for one in node.args.defaults]
    listed = [(*name, default) for name, default in
              zip(names, [inspect.Parameter.empty] * (len(names) - len(defaults)) + defaults)]
    listed += [(one.arg, "keyword", ast.literal_eval(default))
               for one, default in zip(node.args.kwonlyargs, node.args.kw_defaults)]
    if node.args.kwarg:
        listed.append((node.args.kwarg.arg, "keywords", inspect.Parameter.empty))
    return listed


def parameters_there(function):
    kinds = {inspect.Parameter.POSITIONAL_ONLY: "positional",
             inspect.Parameter.POSITIONAL_OR_KEYWORD: "either",
             inspect.Parameter.KEYWORD_ONLY: "keyword",
             inspect.Parameter.VAR_KEYWORD: "keywords"}
    return [(one.name, kinds[one.kind], one.default)
            for one in inspect.signature(function).parameters.values()]


def own_names(cls):
    known = set(dir(enum.IntEnum)) if issubclass(cls, enum.Enum) else EXCEPTION
    return {name for base in cls.__mro__ if base.__module__.startswith("assur")
            for name in vars(base) if not name.startswith("_") and name not in known}


def stub_names(node):
    names = set()
    for base in node.bases:
        if isinstance(base, ast.Name) and base.id in stub_classes():
            names |= stub_names(stub_classes()[base.id])
    for item in node.body:
        if isinstance(item, ast.FunctionDef):
            names.add(item.name)
        elif isinstance(item, (ast.Assign, ast.AnnAssign)):
            names.add((item.target if isinstance(item, ast.AnnAssign) else item.targets[0]).id)
    return {name for name in names if not name.startswith("_")}


def same_kind(mine, theirs):
    # pybind11 marks positional parameters by `/`; Python's own functions accept `self` by name.
    return [(name, default) for name, _, default in mine] == [
        (name, default) for name, _, default in theirs] and [
        kind for name, kind, _ in mine if name != "self"] == [
        kind for name, kind, _ in theirs if name != "self"]


def test_names():
    names = set(stub_classes()) | set(stub_functions(STUB.body))
    assert names == set(assur.__all__)
    assert all(hasattr(assur, name) for name in assur.__all__)
    public = {name for name, item in vars(assur).items()
              if not name.startswith("_") and not inspect.ismodule(item)}
    assert public == set(assur.__all__)


def test_functions():
    for name, node in stub_functions(STUB.body).items():
        assert same_kind(parameters_there(getattr(assur, name)), parameters_of(node)), name


def test_classes():
    checked = 0
    for name, node in stub_classes().items():
        cls = getattr(assur, name)
        assert stub_names(node) == own_names(cls), name
        bases = [base.id for base in node.bases if isinstance(base, ast.Name)]
        assert [base.__name__ for base in cls.__bases__
                if base.__module__ != "pybind11_builtins"] == bases or not bases or (
                    [base.__name__ for base in cls.__bases__] == ["_Word"]), name
        for method, stub in stub_functions(node.body).items():
            there = inspect.getattr_static(cls, method)
            is_property = any(isinstance(one, ast.Name) and one.id == "property"
                              for one in stub.decorator_list)
            assert isinstance(there, property) == is_property, (name, method)
            if not is_property and method not in NAMED - {"__getitem__"}:
                assert same_kind(parameters_there(getattr(cls, method)), parameters_of(stub)), (
                    name, method)
                checked += 1
    assert checked > 20


def test_docstrings():
    assert assur.__doc__
    for name in assur.__all__:
        item = getattr(assur, name)
        assert item.__doc__ and len(item.__doc__.strip()) > 10, name
        if inspect.isclass(item):
            for member in own_names(item):
                there = inspect.getattr_static(item, member)
                if not isinstance(there, (enum.Enum, int, tuple)):
                    assert inspect.getdoc(there), (name, member)


def test_docstrings_tell_shapes():
    for cls in (assur.LinkState, assur.OutputState):
        for member in own_names(cls):
            doc = inspect.getdoc(inspect.getattr_static(cls, member))
            assert doc.startswith(("Array of shape (", "float: ")), (cls, member)


def test_the_marker_of_types_is_there():
    assert (pathlib.Path(assur.__file__).parent / "py.typed").exists()
