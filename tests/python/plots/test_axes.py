"""Pictures in place of axes that are given: in their figure, and nowhere else."""

import matplotlib.pyplot as plt
import pytest
from synthetic_solution import make_solution

import pyworm


@pytest.fixture
def figure():
    made = plt.figure(figsize=(12, 4))
    yield made
    plt.close(made)


def test_a_picture_takes_the_place_of_axes_in_their_grid(figure):
    left, right = figure.subplots(1, 2)
    picture = make_solution().plot.film(ax=left)
    oils = pyworm.plots.draw_viscosity([pyworm.named_oil("PAO VG 220")], ax=right)
    assert figure.subfigs == [picture, oils]
    assert picture.bbox.x1 <= oils.bbox.x0 + 1
    assert len(picture.axes) >= 2
    figure.canvas.draw()


def test_a_picture_takes_the_place_of_axes_anywhere(figure):
    axes = figure.add_axes((0.1, 0.2, 0.5, 0.6))
    picture = make_solution().plot.profiles(ax=axes)
    figure.canvas.draw()
    place = picture.bbox.transformed(figure.transFigure.inverted())
    assert place.bounds == pytest.approx((0.1, 0.2, 0.5, 0.6))


def test_without_axes_each_picture_has_a_figure_of_its_own():
    one, other = (make_solution().plot.profiles() for _ in range(2))
    assert one is not other
    assert not one.subfigs
