"""A new law of viscosity touches two files, one of the kernel and one in Python, and case files have it."""

from dataclasses import replace

import numpy as np
import pytest
from source_copy import SourceCopy

import pyworm

pytestmark = pytest.mark.long

KERNEL, LAWS = "fortran/oil/viscosity_density.f90", "pyworm/materials/viscosity_density.py"

NUMBER = """\
  !> eta = eta0 (1 + alpha p/16)^16 (Cameron 1966)
  integer, parameter, public :: law_cameron = 4
"""

COLD = """\
    else if (oil%law == law_cameron) then
      rise = 16*log(1 + oil%exponent*p/16)
      slope = oil%exponent/(1 + oil%exponent*p/16)
"""

WARM = """\
    if (oil%law == law_cameron) then
      do k = 1, size(rise, 2)
        do i = 1, size(p)
          exponent = 16*log(1 + oil%exponent*p(i)/16) - oil%thermal_exponent*rise(i, k)
          fluidity(i, k) = exp(-exponent)/oil%eta0
          by_pressure(i, k) = -oil%exponent/(1 + oil%exponent*p(i)/16)
          by_temperature(i, k) = oil%thermal_exponent
        end do
      end do
      return
    end if
"""

LAW = '''\
@dataclass(frozen=True, repr=False)
class Cameron(ViscosityLaw):
    """Cameron's law, eta = eta0 (1 + alpha p/16)^16 (Cameron 1966)."""

    CASE_NAME = "cameron"
    KERNEL_NUMBER = 4
    THINNING = Thinning()

    alpha: units.PressureViscosity
    """Pressure-viscosity coefficient at p = 0 [1/Pa]."""

    def __post_init__(self) -> None:
        """Refuse impossible constants of an oil."""
        take(self, sizes=False)

    def __call__(self, pressure: Given) -> Any:
        """Viscosity [Pa s] at a pressure or pressures [Pa]."""
        pressure = in_si("pressure", pressure, units.PressureCoordinate)
        return self.eta0 * (1 + self.alpha * pressure / 16) ** 16

    @property
    def kernel_constants(self) -> tuple[float, float]:
        """alpha, and no pole."""
        return self.alpha, 1.0

    def with_eta0(self, eta0: float | str) -> Self:
        """The law of another viscosity at ambient pressure [Pa s]."""
        return replace(self, eta0=eta0)

    def with_alpha_times(self, factor: float) -> Self:
        """The law of another alpha."""
        return replace(self, alpha=factor * self.alpha)


'''

CASE = """title = "Roller with an oil of Cameron's law"
source = "A test"
accuracy = "2 %"
effects = ["all", "-roughness", "-starvation"]
contact = {{ kind = "line-contact", radius = "10 mm", load = "150 kN/m" }}
motion = {{ velocity_1 = "0.6 m/s", velocity_2 = "0.4 m/s" }}

[bodies.body_1]
youngs_modulus = "206 GPa"
poisson_ratio = 0.3
density = "7850 kg/m^3"
conductivity = "46 W/(m K)"
specific_heat = "460 J/(kg K)"
bulk_temperature = "60 degC"

[bodies.body_2]
youngs_modulus = "206 GPa"
poisson_ratio = 0.3
density = "7850 kg/m^3"
conductivity = "46 W/(m K)"
specific_heat = "460 J/(kg K)"
bulk_temperature = "60 degC"

[oil]
name = "model oil"
viscosity = {{ law = "{law}", eta0 = "0.04 Pa s", alpha = "15 1/GPa" }}
density = {{ law = "dowson-higginson", rho0 = "850 kg/m^3" }}
shear = {{ law = "eyring", stress = "5 MPa" }}

[oil.heat]
inlet_temperature = "60 degC"
beta = "0.04 1/K"
conductivity = "0.14 W/(m K)"
specific_heat = "2000 J/(kg K)"
expansivity = "0.0007 1/K"
"""


@pytest.fixture(scope="module")
def copy(tmp_path_factory) -> SourceCopy:
    copy = SourceCopy.in_folder(tmp_path_factory.mktemp("new_law"))
    copy.insert(KERNEL, "  !> Minus the logarithm of the viscosity [Pa s] where", NUMBER)
    copy.insert(KERNEL, "    else if (oil%law == law_tabulated) then\n", COLD)
    copy.insert(
        KERNEL, "    if (oil%law == law_tabulated) then\n      call tabulated_fluidity", WARM
    )
    copy.insert(LAWS, "VISCOSITY_LAWS: tuple", LAW)
    content = (copy.root / LAWS).read_text()
    copy.write(LAWS, content.replace("= (Barus, Roelands)", "= (Barus, Roelands, Cameron)"))
    copy.build()
    copy.write("cameron.toml", CASE.format(law="cameron"))
    return copy


def test_it_is_two_files(copy):
    assert copy.changed() == {KERNEL, LAWS}


def test_a_case_with_it_has_the_films_of_its_table(copy, tmp_path):
    """The film of the law itself, solved by the copy, against that of a table of the law's function."""
    copy.pyworm("run", "cameron.toml", "--pictures", "none", "--out", str(tmp_path / "out"))
    (solved,) = pyworm.open_result(tmp_path / "out" / "result.nc").solutions
    (tmp_path / "barus.toml").write_text(CASE.format(law="barus"))
    scene = pyworm.load(tmp_path / "barus.toml").scene()
    table = pyworm.TabulatedViscosity.of(
        lambda p, warmth: 0.04 * (1 + 15e-9 * p / 16) ** 16 * np.exp(-0.04 * (warmth - 333.15)),
        "60 degC",
    )
    heat = replace(scene.oil.thermal, viscosity_exponent=0.0)
    same = replace(scene, oil=replace(scene.oil, viscosity=table, heat=heat))
    expected = pyworm.solve(
        same, pyworm.plan(same, 0.02, ("all", "-roughness", "-starvation"))
    ).figures
    for name in ("film_central", "film_min", "friction_coefficient"):
        value = getattr(expected, name).value
        assert getattr(solved.figures, name).value == pytest.approx(value, rel=1e-3), name
    thick = pyworm.solve(
        scene, pyworm.plan(scene, 0.02, ("all", "-roughness", "-starvation"))
    ).figures
    assert thick.friction_coefficient.value > 1.02 * expected.friction_coefficient.value


def test_its_constants_are_checked_as_those_of_others(copy):
    copy.write("wrong.toml", CASE.format(law="cameron").replace("15 1/GPa", "15 MPa"))
    ended = copy.python("-m", "pyworm.cli", "check", "wrong.toml")
    assert ended.returncode == 2
    assert "oil.viscosity.alpha" in ended.stderr
