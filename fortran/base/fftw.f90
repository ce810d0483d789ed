!> The C interface of FFTW 3 as Fortran sees it.
module pyworm_fftw
  use, intrinsic :: iso_c_binding
  implicit none(type, external)
  public

  include 'fftw3.f03'

end module pyworm_fftw
