"""Write docs/config.md and the grammars that come with the package from the schema: ``python docs/make_config.py``."""

from __future__ import annotations

from pathlib import Path
from typing import Iterable, Iterator, List, Sequence

import rqt_mrta_py.config.schema
from rqt_mrta_py.config.packages.answers_form import ANSWERS
from rqt_mrta_py.config.schema.exports import EXPORTS
from rqt_mrta_py.config.schema.forms import Content, ElementForm, XmlForm
from rqt_mrta_py.config.schema.relax_ng import HIGHEST_NUMBER
from rqt_mrta_py.config.schema.shared_elements import CONFIGS, LAUNCHES
from rqt_mrta_py.config.schema.shipped import XML_FORMS, YAML_FORMS, grammars
from rqt_mrta_py.config.substitution import TOKENS
from rqt_mrta_py.config.yaml.schema import REQUIRED, Key, Table, ValueType

SHARED = (CONFIGS, LAUNCHES)

INTRODUCTION = """# Configuration reference

Everything that the files of a package may hold. This page is written from the tables by which files are checked:
`python docs/make_config.py`. How the reading is built: [rooms/config.md](rooms/config.md).

What nobody reads is an error, told with line and nearest known name; `mrta doctor` tells all of a package at once.
"""

MANIFEST = """## package.xml

A package takes part if it depends directly on `rqt_mrta` or `rqt_mrta_py` (`run_depend`, `exec_depend` or `depend`;
manifest formats 1, 2 and 3) and exports a tag of either name:

```xml
<exec_depend>rqt_mrta_py</exec_depend>
<export>
  <rqt_mrta_py application="${prefix}/rqt_mrta.xml" tasks="${prefix}/tasks.yaml" scenario="${prefix}/scenario.yaml"/>
</export>
```

`${prefix}` is the package's folder. One package may register an architecture and an application, in one tag or two.
"""

RULES = """Rules for both flavours of `rqt_mrta.xml`:

* An empty element equals an absent one. The order of elements does not count.
* Text is trimmed, wrapped lines are joined by one blank. Comments are passed over.
* Numbered elements stand in the order of their numbers, which may have gaps. A number that stands twice is an error.
* Ids lose one leading slash: `/robot1` on the wire and `robot1` in a file are one robot.
* `format` at the root may be absent; it must not contradict.
* Entities are refused.
"""

LAYERS = """## Where parameters come from

The config that `config_id` names is the template of every robot's parameters. What is further down covers what is
further up:

| layer | for all robots | for one robot |
|---|---|---|
| `value`, else `default`, of the architecture's template | yes | |
| configs of the application's `rqt_mrta.xml`, under its own architecture | `<config_id>` | `<robot>_<config_id>` |
| YAML files beside it, under its own architecture | `config/<config_id>.yaml` | `config/<robot>_<config_id>.yaml` |
| YAML files, under another architecture | the same in `config/<architecture>` | the same in `config/<architecture>` |
| the command line | | `--set <robot>/<path>=<value>` |

Paths join names by `/`, such as `behaviour_sets/behaviour_set0/task_id`. Configs that are no robot's are read likewise
under their own id. The size of an array is what a layer gives, else as many elements as layers speak of, else what its
template says; elements that stand for tasks are as many as the robot's tasks.
"""

TOKEN_RULE = """In names, values and defaults of parameters, and in all texts of launches. A token that stands for
nothing where it is, and any other text between two `@`, stays as it is.
"""

GRAMMARS = """With the package come, written from the same tables: {files}.
They lie in the folder that this prints:

```console
$ python3 -c 'import rqt_mrta_py.config.schema as s; print(s.__path__[0])'
```

RELAX NG lists numbered elements up to {highest}; `mrta` itself has no such bound. What a grammar cannot say, such as an
id that stands twice, `mrta doctor` says.
"""


def render() -> str:
    """Render the page."""
    parts = [INTRODUCTION, MANIFEST, *exports(), RULES]
    for form in XML_FORMS:
        parts += xml_form(form)
    parts += shared(XML_FORMS[0])
    parts += tokens()
    parts.append(LAYERS)
    for table in YAML_FORMS:
        parts += yaml_file(table)
    for table in ANSWERS.values():
        parts += yaml_file(table)
    parts += shipped()
    return "\n".join(parts).rstrip() + "\n"


def exports() -> Iterator[str]:
    """Write the attributes of the export tag."""
    further = {True: " The original does not know it.", False: ""}
    rows = [(f"`{entry.name}`", entry.value, entry.summary + further[entry.ours]) for entry in EXPORTS]
    return table_of(("attribute", "holds", ""), rows)


def xml_form(form: XmlForm) -> Iterator[str]:
    """Write a flavour of rqt_mrta.xml: a table for each element that holds elements of its own."""
    yield f"## rqt_mrta.xml of an {form.name}\n"
    yield f"{form.summary} `format` at the root says `{form.format}`.\n"
    yield from elements(form.root, form.root.name, form)
    shared_paths = tuple(element.step for element in SHARED)
    for path, element in form.walk():
        if not path.startswith(shared_paths):
            yield from elements(element, path, form)


def shared(form: XmlForm) -> Iterator[str]:
    """Write what is the same in all flavours."""
    yield f"## {' and '.join(element.name for element in SHARED)} of both flavours\n"
    shared_paths = tuple(element.step for element in SHARED)
    for path, element in form.walk():
        if path.startswith(shared_paths):
            yield from elements(element, path, form)


def elements(element: ElementForm, path: str, form: XmlForm) -> Iterator[str]:
    """Write what one element holds; nothing of one that holds a text, or only one kind of elements."""
    children = element.children
    if not children or (len(children) == 1 and children[0].content is Content.ELEMENTS and not element.group):
        return
    yield f"### `{path}`\n"
    yield f"{sentence(element)}\n"
    rows = [
        (names([child]), holds(child, form), default_of(child), child.reader, sentence(child)) for child in children
    ]
    if element.group:
        rows.append((names(form.groups[element.group]), "", "", "", "Any number of them."))
    yield from table_of(("element", "holds", "default", "read by", ""), rows)


def names(found: Iterable[ElementForm]) -> str:
    """List elements by their names."""
    return ", ".join(f"`{name}`" for element in found for name in element.names)


def holds(element: ElementForm, form: XmlForm) -> str:
    """Say what an element holds, with the unit of a number."""
    if element.content is Content.ELEMENTS:
        return names(form.inside(element))
    return f"{element.content.value} [{element.unit}]" if element.unit else element.content.value


def default_of(element: ElementForm) -> str:
    """Say what the absence of an element means."""
    return "must be there" if element.required else element.default


def sentence(element: ElementForm) -> str:
    """Give an element's sentence, which texts are understood, and whether the original knows it."""
    parts = [element.summary]
    if element.spellings:
        parts.append(f"Understood: {', '.join(f'`{text}`' for text in element.spellings)}.")
    if element.ours:
        parts.append("The original does not know it.")
    return " ".join(parts)


def tokens() -> Iterator[str]:
    """Write what tokens stand for."""
    yield "## Tokens\n"
    yield TOKEN_RULE
    yield from table_of(("token", "stands for"), [(f"`{token}`", text) for token, text in TOKENS.items()])


def yaml_file(table: Table) -> Iterator[str]:
    """Write a YAML file: a table for each kind of mapping in it."""
    yield f"## {table.name}\n"
    yield f"{table.summary}\n"
    yield from keys(table)
    for inner in tables_in(table):
        yield f"### {table.name}: {inner.name}\n"
        yield f"{inner.summary}\n"
        yield from keys(inner)
        for value, variant in inner.variants.items():
            further = [
                f"`{key.name}` ({accepts(key)}): {key.summary}" if key.table is None else parameters(key)
                for key in variant.keys
            ]
            yield f"* `{inner.by}: {value}`: {variant.summary} {' '.join(further)}".rstrip()
        if inner.variants:
            yield ""


def tables_in(table: Table) -> List[Table]:
    """List the tables of the mappings within, each once, those that variants alone have left out."""
    found: List[Table] = []
    for key in table.keys:
        if key.table is not None:
            found += [inner for inner in (key.table, *tables_in(key.table)) if inner not in found]
    return found


def keys(table: Table) -> Iterator[str]:
    """Write the keys of a mapping."""
    rows = [(f"`{key.name}`", accepts(key), default_of_key(key), key.summary) for key in table.keys]
    return table_of(("key", "holds", "default", ""), rows)


def parameters(key: Key) -> str:
    """Write the keys of a mapping that one variant alone has, in a line."""
    table = key.table
    if table is None or table.further:
        return f"`{key.name}`: {key.summary}"
    return f"`{key.name}`: " + " ".join(f"`{inner.name}` ({accepts(inner)}): {inner.summary}" for inner in table.keys)


def accepts(key: Key) -> str:
    """Say what a key holds: type, bounds, unit."""
    words = [f"a list of {key.count} numbers" if key.count is not None else key.type.value]
    if key.choices:
        words = ["one of", ", ".join(f"`{choice}`" for choice in key.choices)]
    elif key.table is not None:
        words = [f"{'a list of ' if key.type is ValueType.TABLES else ''}`{key.table.name}`"]
    bounds = (("from", key.minimum), ("to", key.maximum), ("above", key.above))
    words += [f"{word} {bound:g}" for word, bound in bounds if bound is not None]
    return " ".join([*words, f"[{key.unit}]"] if key.unit else words)


def default_of_key(key: Key) -> str:
    """Say what the absence of a key means."""
    if key.default is REQUIRED:
        return "must be there"
    if key.default is None or key.default in ((), {}):
        return "none"
    return f"`{str(key.default).lower() if isinstance(key.default, bool) else key.default}`"


def shipped() -> Iterator[str]:
    """Write where grammars are."""
    yield "## Grammars for editors\n"
    yield GRAMMARS.format(files=", ".join(f"`{name}`" for name in grammars()), highest=HIGHEST_NUMBER)


def table_of(heads: Sequence[str], rows: Iterable[Sequence[str]]) -> Iterator[str]:
    """Write a table."""
    yield f"| {' | '.join(heads)} |"
    yield "|" + "---|" * len(heads)
    for row in rows:
        yield f"| {' | '.join(row)} |"
    yield ""


if __name__ == "__main__":
    (Path(__file__).parent / "config.md").write_text(render(), encoding="utf-8")
    for name, text in grammars().items():
        (Path(rqt_mrta_py.config.schema.__path__[0]) / name).write_text(text, encoding="utf-8")
