program test_oil_heat
  use tap, only: check, done
  implicit none(type, external)
  call check(.true., "x")
  call done()
end program test_oil_heat
