program test_flow_laws
  use tap, only: check, done
  implicit none(type, external)
  call check(.true., "x")
  call done()
end program test_flow_laws
