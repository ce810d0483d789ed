!> Flow laws by their curve: those of Carreau and Eyring come back from it.
program test_flow_table
  use pyworm_flow_laws, only: flow_law, law_carreau, law_tabulated, thinning
  use pyworm_flow_table, only: branches_curve, curve_points, flow_branch, newtonian_ratios, table_curve, tabulate_flow
  use pyworm_kinds, only: wp
  use tap, only: check, close_to, done
  implicit none(type, external)
  real(wp), parameter :: g = 4e6_wp
  real(wp) :: newtonian(curve_points), stress(curve_points), few(3)
  type(flow_law) :: law
  integer :: i

  newtonian = newtonian_ratios()
  call close_to(newtonian(1), 1e-6_wp, 1e-20_wp, "curves begin at rest")
  call close_to(newtonian(size(newtonian)), 1e16_wp, 1e6_wp, "and end beyond all rates")

  stress = branches_curve([flow_branch(0.25_wp, 1.0_wp, 0.6_wp), flow_branch(0.75_wp, 1.0_wp, 0.6_wp)], newtonian)
  call close_to(maxval(abs(stress/(newtonian*(1 + newtonian**2)**(-0.2_wp)) - 1)), 0.0_wp, 1e-13_wp, "equal branches are one")
  law = flow_law(law_tabulated, g)
  call tabulate_flow(newtonian, stress, law%by_stress, law%by_rate)
  ! Carreau's law by stress is not that by rate, but both are a power law far from rest: tau/G = y^n
  call close_to(thinning_at(law, 1e3_wp), 1e3_wp**(1/0.6_wp - 1), 2e-2_wp, "Carreau's power law")
  call close_to(thinning_at(law, 1e3_wp)/thinning_at(flow_law(law_carreau, g, exponent=0.6_wp), 1e3_wp), 1.0_wp, 1e-3_wp, &
    "is that of the law by stress")

  stress = table_curve(reshape([(10**(0.1_wp*i), asinh(10**(0.1_wp*i)), i=-40, 60)], [2, 101]), newtonian)
  call tabulate_flow(newtonian, stress, law%by_stress, law%by_rate)
  call close_to(thinning_at(law, 0.01_wp), sinh(0.01_wp)/0.01_wp, 1e-5_wp, "a table of Eyring's law near rest")
  call close_to(thinning_at(law, 3.0_wp), sinh(3.0_wp)/3, 1e-4_wp, "and where it thins")
  few = table_curve(reshape([1.0_wp, 1.0_wp, 2.0_wp, 1.9_wp, 4.0_wp, 3.5_wp, 8.0_wp, 6.0_wp], [2, 4]), [0.5_wp, 2.0_wp, 80.0_wp])
  call close_to(few(1), 0.5_wp, 1e-15_wp, "before a table an oil is Newtonian")
  call close_to(few(2), 1.9_wp, 1e-15_wp, "a table's points lie on its curve")
  call check(few(3) > 6 .and. few(3) < 60, "beyond a table it is a power law")
  call done()

contains

  !> Thinning at a stress over G.
  real(wp) function thinning_at(law, ratio)
    type(flow_law), intent(in) :: law
    real(wp), intent(in) :: ratio
    real(wp) :: found(1), slope(1)

    call thinning(law, 1, [(ratio*g)**2], [1/g**2], [0.0_wp], found, slope)
    thinning_at = found(1)
  end function thinning_at

end program test_flow_table
