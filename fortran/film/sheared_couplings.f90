!> Couplings of neighbouring pressures through a sheared film, for the preconditioner: the exact derivatives of the flow
!> through faces, but those by the pressure gradient along a face, on a grid or on a coarser one. Diffusion is added where
!> a coupling would be negative, as where the walls' slip carries the oil: sweeps grow without bound otherwise.
module pyworm_sheared_couplings
  use pyworm_kinds, only: pp, wp
  use pyworm_rough_surfaces, only: rough_film
  use pyworm_face_flow, only: face_flow
  implicit none(type, external)
  private

  public :: couple_row

contains

  !> Computes the couplings through the faces after a row of nodes of every `stride`-th of the film's: outflow by the
  !> pressure of the node before, `leave`, and inflow by that of the node after, `enter` [m/(s Pa)].
  !>
  !> The row starts at node `start` of the coarse grid and goes on by `step`; the faces lie in the direction `along`. Each is
  !> the mean of the faces of the film's grid that it spans; `spacing` [m] is that of the coarse grid. The film
  !> follows the pressure by `compliance` [m/Pa]; between rough surfaces the pressure is the total, and the oil's rises more, as
  !> the asperities yield.
  pure subroutine couple_row(faces, stride, start, step, along, spacing, compliance, leave, enter, rough)
    type(face_flow), intent(in) :: faces
    integer, intent(in) :: stride, start(2), step(2), along(2)
    real(pp), intent(in) :: spacing, compliance
    real(pp), intent(out) :: leave(:), enter(:)
    type(rough_film), intent(in), optional :: rough
    real(wp) :: mobility, before, after, film_before, film_after, diffusion
    integer :: first(2), last(2), k, s, i, j

    do k = 1, size(leave)
      mobility = 0
      before = 0
      after = 0
      film_before = 0
      film_after = 0
      first = 1 + stride*(start - 1 + (k - 1)*step)
      last = first + (stride - 1)*along
      do s = 0, stride - 1
        i = first(1) + s*along(1)
        j = first(2) + s*along(2)
        mobility = mobility + faces%mobility(i, j)
        before = before + faces%before(i, j)
        after = after + faces%after(i, j)
        film_before = film_before + faces%film_before(i, j)
        film_after = film_after + faces%film_after(i, j)
      end do
      ! the part by the gradient falls with the spacing, the rest does not
      mobility = mobility*(1.0_wp/stride - 1)*stride/spacing
      before = mobility - before
      after = mobility + after
      if (present(rough)) then
        after = after*(1 + compliance*rough%stiffness(last(1) + along(1), last(2) + along(2)))
        before = before*(1 + compliance*rough%stiffness(first(1), first(2)))
      end if
      before = before - compliance*film_before
      after = after + compliance*film_after
      diffusion = max(0.0_wp, -before, -after)
      leave(k) = real((before + diffusion)/(stride*spacing), pp)
      enter(k) = real((after + diffusion)/(stride*spacing), pp)
    end do
  end subroutine couple_row

end module pyworm_sheared_couplings
