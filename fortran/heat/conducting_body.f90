!> A body under a contact, with the model of conduction that suits its motion.
module pyworm_conducting_body
  use pyworm_conduction_model, only: conduction_errors, of_greatest
  use pyworm_heated_surface, only: heated_body
  use pyworm_kinds, only: wp
  use pyworm_moving_source, only: moving_body, new_moving_body
  use pyworm_status, only: status_ok
  use pyworm_surface_path, only: fast_body, new_fast_body
  implicit none(type, external)
  private

  public :: new_conducting_body

contains

  !> Makes the model of the smaller error; where paths turn back within the window, that of uniform velocity.
  !>
  !> The surface moves with (u, v) [m/s] at the nodes; `heat` is proportional to the heat flux, over a contact of the
  !> semi-axes `semi` [m], on nodes `spacing` [m] apart. `error` is that of the greatest rise by the model (`conduction_model`).
  subroutine new_conducting_body(u, v, heat, semi, spacing, conductivity, capacity, body, error, stat)
    real(wp), contiguous, intent(in) :: u(:, :), v(:, :), heat(:, :)
    real(wp), intent(in) :: semi(2), spacing(2), conductivity, capacity
    class(heated_body), allocatable, intent(out) :: body
    real(wp), intent(out) :: error
    integer, intent(out) :: stat
    type(moving_body), allocatable :: uniform
    type(fast_body), allocatable :: fast
    real(wp) :: mean_u, mean_v, along_paths

    call conduction_errors(u, v, heat, semi(1), semi(2), conductivity/capacity, mean_u, mean_v, error, along_paths)
    if (along_paths < error) then
      allocate (fast)
      call new_fast_body(fast, spacing(1), spacing(2), u, v, conductivity, capacity, stat)
      if (stat == status_ok) then
        error = of_greatest*along_paths
        call move_alloc(fast, body)
        return
      end if
    end if
    error = of_greatest*error
    allocate (uniform)
    call new_moving_body(uniform, size(u, 1), size(u, 2), spacing(1), spacing(2), mean_u, mean_v, conductivity, &
      capacity, stat)
    call move_alloc(uniform, body)
  end subroutine new_conducting_body

end module pyworm_conducting_body
