"""Our own dataclasses on the wire: pydantic reads and writes them as they are, where the page sees all of their fields.

A view that differs, or has limits of its own, is a model; as a `View` it reads our values by the names of their fields.
"""

from __future__ import annotations

from typing import Annotated, Any, TypeVar

from pydantic import AfterValidator, AliasChoices, BaseModel, ConfigDict, Field, GetJsonSchemaHandler, model_validator
from pydantic.json_schema import JsonSchemaValue
from pydantic_core import CoreSchema

from kitrobot.files.recovery import ClaimedJournal
from kitrobot.mission.model import Agent, Goal
from kitrobot.mission.reader import describe_goal_stock, is_goal_stock
from kitrobot.sim.breakpoints import Hit
from kitrobot.tutorial.model import Point

T = TypeVar("T")


class View(BaseModel):
    """What the page sees of a value of ours: `model_validate` takes that value as it is."""

    model_config = ConfigDict(from_attributes=True, serialize_by_alias=True)


class Row(View):
    """A view of a tuple: its fields are the numbers and names of that, in order."""

    @model_validator(mode="before")
    @classmethod
    def _fields(cls, given: Any) -> Any:
        return dict(zip(cls.model_fields, given, strict=True)) if isinstance(given, tuple) else given


Least = Annotated[T, Field(validation_alias=AliasChoices("min", "minimum"))]
Most = Annotated[T, Field(validation_alias=AliasChoices("max", "maximum"))]
"""The ends of a range: the page says `min` and `max`, for `minimum` and `maximum`."""


class WireFields:
    """Says in the schema of a dataclass that all fields travel but the `optional` ones, also of those in it (`deep`).

    A default of a dataclass is for Python: the page always sends and gets the field.
    """

    def __init__(self, *optional: str, deep: bool = True) -> None:
        self._optional = optional
        self._deep = deep

    def __get_pydantic_json_schema__(self, core: CoreSchema, handler: GetJsonSchemaHandler) -> JsonSchemaValue:
        """The schema of the dataclass, or of a list of them, with their fields required."""
        made = handler(core)
        self._require(made, handler)
        return made

    def _require(self, schema: dict[str, Any], handler: GetJsonSchemaHandler) -> None:
        inner = handler.resolve_ref_schema(schema) if "$ref" in schema else schema
        properties = inner.get("properties", {})
        if properties:
            inner["required"] = [name for name in properties if name not in self._optional]
        for part in (*(properties.values() if self._deep else ()), *inner.get("anyOf", ()), inner.get("items")):
            if isinstance(part, dict):
                self._require(part, handler)


def _goal(goal: Goal) -> Goal:
    if not is_goal_stock(goal.stock):
        raise ValueError(describe_goal_stock(goal.stock))
    return goal


AgentValue = Annotated[Agent, WireFields("robot")]
GoalValue = Annotated[Goal, WireFields(), AfterValidator(_goal)]
HitValue = Annotated[Hit, WireFields()]
ClaimedValue = Annotated[ClaimedJournal, WireFields()]
PointValue = Annotated[Point, WireFields()]
