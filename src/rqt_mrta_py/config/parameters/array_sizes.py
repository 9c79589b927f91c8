"""How many elements an array of parameters has: as many as tasks, as given, or as the template says.

Where the items of an array mention ``@task_id@``, its elements stand for the robot's tasks: some name theirs, the
others take those that are left, in order.
"""

from __future__ import annotations

import re
from typing import Callable, Dict, Optional, Sequence

from rqt_mrta_py.config.parameters.context import ArraySize, ParameterContext, Path, Place
from rqt_mrta_py.config.parameters.layers import Given, GivenValues
from rqt_mrta_py.config.parameters.values import check_value, parse_text
from rqt_mrta_py.config.substitution import INDEX_TOKEN, SIZE_TOKEN, substitute
from rqt_mrta_py.model import TASK_TOKEN, ArrayTemplate, MapTemplate, ParameterTemplate, ParameterType, TemplateItem
from rqt_mrta_py.wording import accepted, shown

__all__ = ["ArraySizer", "element_name"]

_MOST_ELEMENTS = 1000


class ArraySizer:
    """Sizes arrays by what is given.

    Args:
        given: values of all layers.
        context: for whom.
        note: called with path, value and message of everything that is wrong.
    """

    def __init__(self, given: GivenValues, context: ParameterContext, note: Callable[[Path, Given, str], None]) -> None:
        self._given = given
        self._context = context
        self._note = note

    def of(self, items: Sequence[TemplateItem], place: Place) -> Optional[ArraySize]:
        """Find out how many elements the arrays of a group have.

        Args:
            items: of the group.
            place: of the group.

        Returns:
            Their number and what they are for; None if the group holds no array.
        """
        arrays = [item for item in items if isinstance(item, ArrayTemplate)]
        sizes = [item for item in items if isinstance(item, ParameterTemplate) and item.name == "size"]
        if not arrays or not sizes:
            return None
        by_task = not place.in_task_array and any(map(_stands_for_tasks, arrays))
        seen = max([self._highest_index(array, place) + 1 for array in arrays])
        explicit = self._explicit_size(sizes[0], place)
        if not by_task:
            return ArraySize(explicit if explicit is not None else self._implied_size(sizes[0], place, seen))
        seen = seen if explicit is None else min(seen, explicit)
        claims = self._claims(arrays, place, seen)
        left = [task for task in self._context.tasks if task not in claims.values()]
        free = [index for index in range(seen + len(left)) if index not in claims]
        tasks = {**claims, **dict(zip(free, left))}
        size = explicit if explicit is not None else max([seen, *(index + 1 for index in tasks)])
        missing = [task for index, task in tasks.items() if index >= size]
        if missing and self._context.all_tasks and not self._context.partial:
            path = (*place.path, "size")
            given = self._given.get(path) or Given(None, True, self._context.template_source, sizes[0].line)
            message = f"is {size}, which leaves no element for {', '.join(missing)}; give {len(tasks)}"
            for task in claims.values():
                if task not in self._context.tasks:
                    message += f", or mend {task!r}, which is no task of its own: {accepted(task, self._context.tasks)}"
            self._note(path, given, message)
        return ArraySize(size, {index: tasks[index] for index in sorted(tasks)}, by_task=True)

    def _explicit_size(self, item: ParameterTemplate, place: Place) -> Optional[int]:
        """Give the size that a layer gives as a number; None if none does."""
        inner = place.inner(item.name)
        given = self._given.look_up(inner)
        if given is None or given.value == SIZE_TOKEN:
            return None
        try:
            size = parse_text(given.value, ParameterType.INT) if given.is_text else check_value(given.value, item.type)
            if isinstance(size, int) and 0 <= size <= _MOST_ELEMENTS:
                return size
            raise ValueError(f"must be a whole number from 0 to {_MOST_ELEMENTS} (got {shown(size)})")
        except ValueError as error:
            self._note(inner.path, given, str(error))
            return None

    def _implied_size(self, item: ParameterTemplate, place: Place, seen: int) -> int:
        texts = [text for text in (item.value, item.default) if text is not None]
        numbers = [int(text) for text in texts if re.match(r"[0-9]{1,9}\Z", text)]
        if texts and texts[0] == SIZE_TOKEN:
            return seen or (min(numbers[0], _MOST_ELEMENTS) if numbers else 0)
        if not texts and not self._context.partial:
            where = Given(None, True, self._context.values_source, self._context.values_line)
            self._note((*place.path, "size"), where, "is mandatory and has no value; give a whole number")
        return min(numbers[0], _MOST_ELEMENTS) if numbers else seen

    def _highest_index(self, array: ArrayTemplate, place: Place) -> int:
        """Give the highest index for which a layer gives anything; -1 if there is none."""
        name = substitute(element_name(array, by_task=False), place.fixed)
        before, _, after = name.partition(INDEX_TOKEN)
        pattern = re.compile(f"{re.escape(before)}([0-9]{{1,4}}){re.escape(after)}\\Z")
        depth = len(place.path)
        highest = -1
        for path in self._given.paths:
            if len(path) > depth and path[:depth] == place.path:
                match = pattern.match(path[depth])
                if match is not None and int(match.group(1)) < _MOST_ELEMENTS:
                    highest = max(highest, int(match.group(1)))
        return highest

    def _claims(self, arrays: Sequence[ArrayTemplate], place: Place, seen: int) -> Dict[int, str]:
        """Give the tasks that elements name themselves, by index."""
        claims: Dict[int, str] = {}
        for array in arrays:
            name = element_name(array, by_task=True)
            for item in array.items:
                if not isinstance(item, ParameterTemplate) or TASK_TOKEN not in (item.value, item.default):
                    continue
                for index in range(seen):
                    given = self._given.get(place.element(name, index, ArraySize(seen)).inner(item.name).path)
                    if given is not None and isinstance(given.value, str) and TASK_TOKEN not in given.value:
                        claims.setdefault(index, given.value)
        return claims


def element_name(array: ArrayTemplate, by_task: bool) -> str:
    """Give the name of an array's elements, which tells them apart: by index if the template does not say how."""
    told = INDEX_TOKEN in array.name or (by_task and TASK_TOKEN in array.name)
    return array.name if told else f"{array.name}{INDEX_TOKEN}"


def _stands_for_tasks(array: ArrayTemplate) -> bool:
    return TASK_TOKEN in array.name or _mentions_task(array.items)


def _mentions_task(items: Sequence[TemplateItem]) -> bool:
    return any(
        TASK_TOKEN in (item.value or "") or TASK_TOKEN in (item.default or "")
        if isinstance(item, ParameterTemplate)
        else isinstance(item, MapTemplate) and _mentions_task(item.items)
        for item in items
    )
