"""Contacts whose bodies are rough."""

from dataclasses import replace

from pyworm.scene.contact import Contact


def rough(scene: Contact, height: float, **finish: float) -> Contact:
    """A scene whose bodies have equal roughness, together of a height [m], and what else `Body` takes."""
    bodies = tuple(replace(body, roughness=height / 2**0.5, **finish) for body in scene.bodies)
    return replace(scene, bodies=bodies)
