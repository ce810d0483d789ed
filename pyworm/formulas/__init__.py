"""Closed forms, a module a subject: `pyworm.formulas.hertz`, `film`, `regimes` and others."""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
