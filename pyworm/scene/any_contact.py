"""The kinds of contact that are planned and solved, for annotations."""

from pyworm.scene.line import LineScene
from pyworm.scene.point import Scene

AnyContact = Scene | LineScene
"""A point contact or a line contact."""
