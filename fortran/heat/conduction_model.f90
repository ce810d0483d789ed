!> Choice of the model of conduction of a body: uniform velocity with conduction in all directions (`moving_source`),
!> or paths of its points with conduction into depth and to their sides (`surface_path`).
!>
!> The error estimates below were fitted to differences of the models, between and within each, for Hertzian
!> sources of axes 1:10 to 10:1. An error is the largest of the temperature where the flux exceeds half of the
!> greatest, over the greatest rise. The greatest rise itself, of which results are made, is off by less (`of_greatest`).
module pyworm_conduction_model
  use pyworm_kinds, only: wp
  implicit none(type, external)
  private

  public :: conduction_errors, of_greatest

  !> Error over the deviation of the speed, since a rise varies as the root of speed; 0.40 to 0.53 were found.
  real(wp), parameter :: by_speed = 0.45_wp
  !> Error over the shift of heat by the deviation of the direction, in half widths of the contact; 0.20 to
  !> 0.26 were found.
  real(wp), parameter :: by_direction = 0.22_wp
  !> Error by conduction along the paths, times U a/kappa with the shorter half chord a: 0.16 to 0.5 were
  !> found.
  real(wp), parameter :: by_conduction = 0.5_wp
  !> Speed at which motion removes a source's heat as well as conduction, times a/kappa: the rise of a uniform
  !> disk, 2 q a/(k sqrt(pi (4/pi + U a/(2 kappa)))), has the exact limits at rest and at great speed.
  real(wp), parameter :: conducting_speed = 8/acos(-1.0_wp)
  !> Error of the greatest rise over that of the temperature: up to 0.62 was found for sources q, q**3 and skewed ones, 0.01 to
  !> 0.3 at U a/kappa above 20 and for a direction that varies.
  real(wp), parameter :: of_greatest = 2.0_wp/3

contains

  !> Mean velocity [m/s] of a surface weighted by `heat` (of any unit, not negative), and the errors of a model with
  !> this velocity, `uniform`, and of one that follows paths, `along_paths`.
  !>
  !> The surface moves with `u`, `v` [m/s]; the contact's semi-axes along x and y [m], diffusivity kappa
  !> [m2/s].
  pure subroutine conduction_errors(u, v, heat, semi_x, semi_y, diffusivity, mean_u, mean_v, uniform, along_paths)
    real(wp), intent(in) :: u(:, :), v(:, :), heat(:, :), semi_x, semi_y, diffusivity
    real(wp), intent(out) :: mean_u, mean_v, uniform, along_paths
    real(wp) :: share(size(u, 1), size(u, 2)), speed, cosine, sine, along, across, faster, aside, conducted

    share = 1.0_wp/size(u) ! of surfaces that press nowhere yet
    if (sum(heat) > 0) share = heat/sum(heat)
    mean_u = sum(share*u)
    mean_v = sum(share*v)
    speed = hypot(mean_u, mean_v)
    cosine = 1
    sine = 0
    if (speed > 0) then
      cosine = mean_u/speed
      sine = mean_v/speed
    end if
    ! half chords of the contact along and across the motion
    along = 1/hypot(cosine/semi_x, sine/semi_y)
    across = 1/hypot(sine/semi_x, cosine/semi_y)
    conducted = conducting_speed*diffusivity/min(along, across)
    faster = sqrt(sum(share*((u - mean_u)*cosine + (v - mean_v)*sine)**2))
    aside = sqrt(sum(share*((v - mean_v)*cosine - (u - mean_u)*sine)**2))
    uniform = (by_speed*faster + by_direction*aside*along/across)/(speed + conducted)
    along_paths = huge(1.0_wp)
    if (speed > 0) along_paths = by_conduction*diffusivity/min(along, across)/speed
  end subroutine conduction_errors

end module pyworm_conduction_model
