"""Minifies Python for a board: no comments, no docstrings, short names inside functions.

Names that other modules use are kept. The result is source code, so any MicroPython can compile it.
"""

from __future__ import annotations

import ast

from kitrobot.deploy.errors import PackageError
from kitrobot.deploy.minification.short_names import with_known_locals
from kitrobot.text.sentences import Sentence


def parsed(text: str, name: str) -> ast.Module:
    """The tree of a module.

    Raises:
        PackageError: it is no Python.
    """
    try:
        return ast.parse(text, name)
    except (SyntaxError, ValueError, RecursionError) as error:
        line = getattr(error, "lineno", None) or 1
        reason = getattr(error, "msg", None) or str(error) or Sentence("nested too deeply")
        raise PackageError(
            Sentence("`{name}` line {line} is no Python: {reason}", name, line, reason),
            Sentence("mend the file, then deploy again"),
        ) from None


def shortened(tree: ast.Module) -> str:
    """The source of a module, as short as it can be said without changing what it does."""
    import python_minifier  # only who installs waits for it

    return python_minifier.minify(
        ast.unparse(with_known_locals(tree)),
        remove_literal_statements=True,
        rename_locals=False,
        rename_globals=False,
        hoist_literals=False,
        remove_annotations=True,
        convert_posargs_to_args=False,
        remove_asserts=False,
    )
