"""Numba's type of a `TablePointer`, and what an attribute of one is: an array, or a pointer to a group within.

See https://numba.readthedocs.io/en/stable/extending/low-level.html. The addresses and shapes are loaded where they are
used and marked as never changing, so LLVM loads each once. The arrays own nothing: whoever calls compiled code keeps
them.
"""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
from llvmlite import ir
from numba.core import cgutils, types
from numba.core.typing.templates import AttributeTemplate
from numba.extending import (
    NativeValue,
    infer_getattr,
    lower_getattr_generic,
    models,
    register_model,
    typeof_impl,
    unbox,
)
from numba.np import arrayobj, numpy_support

from kitrobot.sim.jit.table_pointer import Layout, TablePointer

_WORD = ir.IntType(64)
_WORDS = _WORD.as_pointer()


class PointerType(types.Type):
    """A pointer to a group of tables.

    Attributes:
        kinds: the type of each table, by name.
        places: at which word what is told of it begins.
        words: how many words there are for all of them.
    """

    def __init__(self, name: str, kinds: dict[str, Any]) -> None:
        self.kinds = kinds
        self.places: dict[str, int] = {}
        self.words = 0
        for table, kind in kinds.items():
            self.places[table] = self.words
            self.words += kind.words if isinstance(kind, PointerType) else 1 + kind.ndim
        # Types of the same name are the same to Numba.
        super().__init__(f"{name}({', '.join(f'{table}: {kind.name}' for table, kind in kinds.items())})")


@cache
def pointer_type(layout: Layout) -> PointerType:
    """The type of the pointers with this layout."""
    name, tables = layout
    kinds: dict[str, Any] = {}
    for table, kind in tables:
        if isinstance(kind[1], int):
            kinds[table] = types.Array(numpy_support.from_dtype(np.dtype(kind[0])), kind[1], "C")
        else:
            kinds[table] = pointer_type(kind)
    return PointerType(name, kinds)


@typeof_impl.register(TablePointer)
def _type_of(pointer: TablePointer, _: Any) -> PointerType:
    return pointer_type(pointer.layout)


@register_model(PointerType)
class _Model(models.PrimitiveModel):
    def __init__(self, manager: Any, tables: PointerType) -> None:
        super().__init__(manager, tables, _WORDS)


@unbox(PointerType)
def _unbox(_: PointerType, pointer: Any, unboxing: Any) -> NativeValue:
    address = unboxing.pyapi.object_getattr_string(pointer, "address")
    word = unboxing.unbox(types.intp, address)
    unboxing.pyapi.decref(address)
    return NativeValue(unboxing.builder.inttoptr(word.value, _WORDS), is_error=word.is_error)


@infer_getattr
class _Attributes(AttributeTemplate):
    key = PointerType

    def generic_resolve(self, tables: PointerType, name: str) -> Any:  # type: ignore[override]
        return tables.kinds.get(name)


@lower_getattr_generic(PointerType)
def _lower_attribute(context: Any, builder: Any, tables: PointerType, pointer: Any, name: str) -> Any:
    kind, at = tables.kinds[name], tables.places[name]
    if isinstance(kind, PointerType):
        return cgutils.gep_inbounds(builder, pointer, at)
    number = context.get_data_type(kind.dtype)
    size = context.get_abi_sizeof(number)
    data, *shape = (_load(builder, pointer, at + k) for k in range(1 + kind.ndim))
    strides = [context.get_constant(types.intp, size)]
    for length in reversed(shape[1:]):
        strides.insert(0, builder.mul(strides[0], length))
    array = arrayobj.make_array(kind)(context, builder)
    address = builder.inttoptr(data, number.as_pointer())
    arrayobj.populate_array(array, data=address, shape=shape, strides=strides, itemsize=size, meminfo=None)
    return array._getvalue()


def _load(builder: Any, pointer: Any, at: int) -> Any:
    word = builder.load(cgutils.gep_inbounds(builder, pointer, at))
    word.set_metadata("invariant.load", builder.module.add_metadata([]))
    return word
