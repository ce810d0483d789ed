from .layout import write as write
from .oil import draw_viscosity as draw_viscosity
from .regimes import draw_regimes as draw_regimes
from .sweep import draw_sweep as draw_sweep
from .traction import draw_traction as draw_traction
