"""Tables of the best design: variables, and figures before and after."""

from pyworm.io.console import Console
from pyworm.report.table import Table
from pyworm.result.design import BestDesign, DesignFigure


def show_design(found: BestDesign) -> None:
    """Print the best design."""
    console = Console()
    console.print(variables_table(found))
    console.print(figures_table(found))
    if found.front:
        console.print(front_table(found))
    for sentence in found.statements:
        console.print(sentence)


def variables_table(found: BestDesign) -> Table:
    """Values of the case and of the best design."""
    return Table(
        head=("Variable", "Case", "Best", "Bounds"),
        rows=tuple(
            (each.key, each.start, _text(each.best), each.bounds) for each in found.variables
        ),
        title=f"{found.title}: {found.estimates} designs by closed forms, {found.solved} solved",
        narrow=True,
        texts=(3,),
    )


def _text(value: str | float) -> str:
    return value if isinstance(value, str) else f"{value:.6g}"


def figures_table(found: BestDesign) -> Table:
    """Figures of the case and of the best design, with their numerical uncertainties."""
    worst = any(each.worst is not None for each in found.figures)
    return Table(
        head=("Figure", "Case", "Best", "Change", *(["Worst"] if worst else []), "Role"),
        rows=tuple(_figure(each, worst) for each in found.figures),
        note=found.method,
        narrow=True,
        texts=(5 if worst else 4,),
    )


def _figure(each: DesignFigure, worst: bool) -> tuple[str, ...]:
    return (
        each.name,
        each.text(each.before, each.before_error),
        each.text(each.best, each.best_error),
        each.change_text,
        *([each.text(each.worst)] if worst and each.worst is not None else []),
        each.role,
    )


def front_table(found: BestDesign) -> Table:
    """Designs of the Pareto front."""
    keys = tuple(found.front[0].values)
    names = tuple(each.name for each in found.figures)
    return Table(
        head=(*names, *(key.rpartition(".")[2].replace("_", "\n") for key in keys)),
        rows=tuple(
            (
                *(each.text(design.figures[each.name]) for each in found.figures),
                *(_short(design.values[key]) for key in keys),
            )
            for design in found.front
        ),
        title="Pareto front",
        narrow=True,
    )


def _short(value: str | float) -> str:
    number, _, unit = f"{value}".partition(" ")
    try:
        return f"{float(number):.4g} {unit}".rstrip()
    except ValueError:
        return f"{value}"
