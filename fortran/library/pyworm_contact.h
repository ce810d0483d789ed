/* A lubricated contact for C programs; docs/reference/fortran.md has the table of arguments with their units.
 *
 * Numbers in SI; fields have nx*ny entries, x changing fastest, with ny = 1 of a line contact. What may be left away is a null
 * pointer. Procedures return a status, PYWORM_OK or another one. */
#ifndef PYWORM_CONTACT_H
#define PYWORM_CONTACT_H

#ifdef __cplusplus
extern "C" {
#endif

enum pyworm_status {
    PYWORM_OK, PYWORM_BAD_ARGUMENT, PYWORM_NOT_FINITE, PYWORM_NO_PLAN, PYWORM_NOT_CONVERGED, PYWORM_NO_DESCENT,
    PYWORM_NO_MEMORY, PYWORM_INTERRUPTED, PYWORM_INACCURATE
};
enum pyworm_viscosity { PYWORM_BARUS = 1, PYWORM_ROELANDS, PYWORM_TABULATED };
enum pyworm_flow_law {
    PYWORM_NEWTON, PYWORM_EYRING, PYWORM_BAIR_WINER, PYWORM_EYRING_LIMITED, PYWORM_CARREAU, PYWORM_CARREAU_YASUDA,
    PYWORM_TABULATED_FLOW
};

/* velocity, if given, has nx*ny entries of u and of v of body 1, then of body 2, and counts in place of velocity_1 and _2;
 * covered is not zero where both bodies exist; supply is the thickness of the oil layer that enters */
struct pyworm_scene {
    int nx, ny;
    double dx, dy, load, reduced_modulus, velocity_1[2], velocity_2[2];
    const double *gap;
    const int *covered;
    const double *velocity, *supply;
};
/* viscosities and densities have pressure_count*temperature_count entries, pressure changing fastest; by the law
 * PYWORM_TABULATED they count, or the function in place of the viscosities, up to largest_pressure (0: 3 GPa) and from coldest
 * to warmest (0: 60 K below and 240 K above the inlet temperature) */
struct pyworm_oil {
    int law;
    double viscosity, exponent, pole_pressure, d1, d2, temperature, thermal_exponent, expansivity, expansivity_decay,
        conductivity, c1, c2, heat_capacity, k1, k2, b0, b1, b2;
    int pressure_count, temperature_count;
    const double *pressures, *temperatures, *viscosities, *densities;
    double (*viscosity_at)(double pressure, double temperature);
    double largest_pressure, coldest, warmest;
};
struct pyworm_branch {
    double fraction, ratio, exponent, yasuda;
};
/* branches count by PYWORM_CARREAU_YASUDA; by PYWORM_TABULATED_FLOW table has pair_count pairs of viscosity times shear rate and
 * shear stress, both over stress */
struct pyworm_flow {
    int law;
    double stress, limit, limit_pressure, exponent, stress_pressure, stress_temperature;
    int levels, branch_count, pair_count;
    const struct pyworm_branch *branches;
    const double *table;
};
struct pyworm_body {
    double conductivity, heat_capacity, bulk_rise;
};
/* a hardness of zero is none */
struct pyworm_rough_surface {
    double height, slope, aspect, lay, hardness, sharpness, density;
};
struct pyworm_roughness {
    struct pyworm_rough_surface surface[2];
    double boundary_friction;
};
struct pyworm_options {
    double tolerance, accuracy;
    int most_steps;
};
/* figures, their relative errors by the grids, that of both films by the window; coarsening is the spacing of the film's
 * grid over that of the given one */
struct pyworm_found {
    double film_min, film_central, pressure_max, film_min_error, film_central_error, pressure_max_error, window_error,
        residual, load_error;
    int steps, coarsening;
};
/* memory for nx*ny numbers each, for the temperatures at levels as many at each; stresses, heat and temperatures are those of
 * a film with a flow law */
struct pyworm_fields {
    double *p, *h, *asperity_pressure, *fraction, *stress_x, *stress_y, *heat, *rise;
};
struct pyworm_film;

int pyworm_solve_dry(const struct pyworm_scene *scene, double tolerance, double *p, double *approach);
/* flow, bodies (two of them) and roughness may be null */
struct pyworm_film *pyworm_setup(const struct pyworm_scene *scene, const struct pyworm_oil *oil, const struct pyworm_flow *flow,
    const struct pyworm_body *bodies, const struct pyworm_roughness *roughness, int *status);
/* PYWORM_INACCURATE of a film whose errors are above the accuracy; options may be null */
int pyworm_solve(struct pyworm_film *film, const struct pyworm_options *options, struct pyworm_found *found);
int pyworm_advance(struct pyworm_film *film, const struct pyworm_scene *scene, double seconds,
    const struct pyworm_options *options, struct pyworm_found *found);
int pyworm_read(struct pyworm_film *film, const struct pyworm_fields *fields);
void pyworm_free(struct pyworm_film *film);
/* asked once an iteration; not zero ends the call with PYWORM_INTERRUPTED; null for nothing */
void pyworm_interrupt_by(int (*asked)(void));
const char *pyworm_message(int status);
const char *pyworm_version(void);

#ifdef __cplusplus
}
#endif

#endif
