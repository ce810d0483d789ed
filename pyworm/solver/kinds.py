"""Solver of each kind of contact."""

from typing import Any

from pyworm.scene.line import LineScene
from pyworm.scene.point import Scene
from pyworm.solver.contact import ContactSolver
from pyworm.solver.line.contact import LineContactSolver
from pyworm.solver.point.contact import PointContactSolver

SOLVERS: dict[type, type[ContactSolver[Any, Any]]] = {
    Scene: PointContactSolver,
    LineScene: LineContactSolver,
}
"""Solver of each kind of contact, by its scene."""
