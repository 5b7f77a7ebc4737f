# SPDX-License-Identifier: Apache-2.0
"""The type stubs and docstrings name all that the package has, and nothing else."""
import ast
import inspect
import unittest
from pathlib import Path

import roomcast

PACKAGE = Path(roomcast.__file__).parent
NODES = ast.parse((PACKAGE / "__init__.pyi").read_text()).body
STUBS = {node.name: node for node in NODES if isinstance(node, (ast.ClassDef, ast.FunctionDef))}
UNTOLD = {"__repr__", "__module__", "__doc__", "__hash__", "__weakref__", "__dict__"}


def own_names(cls):
    """Of a class, without what every class has."""
    names = set()
    for base in cls.__mro__:
        if base.__module__ == "roomcast" or base.__module__ == "roomcast._core":
            names |= set(vars(base))
    return {name for name in names if not name.startswith("_pybind") and name not in UNTOLD}


class Stubs(unittest.TestCase):
    def test_name_what_the_package_has(self):
        self.assertEqual(set(STUBS), set(roomcast.__all__))
        self.assertTrue((PACKAGE / "py.typed").exists())

    def test_name_the_members_of_every_class(self):
        for name, stub in STUBS.items():
            public = getattr(roomcast, name)
            if not inspect.isclass(public) or name == "Error":
                continue
            told = {node.name for node in stub.body if isinstance(node, ast.FunctionDef)}
            constructed = own_names(public) - {"__init__"} if "__init__" not in told else own_names(public)
            self.assertEqual(told, constructed, name)

    def test_give_functions_the_parameters_that_they_take(self):
        for name, stub in STUBS.items():
            if isinstance(stub, ast.ClassDef):
                continue
            doc = inspect.getdoc(getattr(roomcast, name)) + str(getattr(getattr(roomcast, name), "__code__", ""))
            parameters = [argument.arg for argument in stub.args.args + stub.args.kwonlyargs]
            if name == "watch":
                self.assertEqual(parameters, list(inspect.signature(roomcast.watch).parameters))
            else:
                signature = doc.split("\n")[0]
                for parameter in parameters:
                    self.assertIn(f"{parameter}: ", signature)

    def test_everything_public_is_described(self):
        for name in roomcast.__all__:
            public = getattr(roomcast, name)
            self.assertGreater(len((inspect.getdoc(public) or "").strip()), 10, name)


if __name__ == "__main__":
    unittest.main()
