"""Pictures: `solution.plot` has those of a solution, the functions here those of more than one."""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
