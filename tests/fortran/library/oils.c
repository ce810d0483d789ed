/* Oils by a table, by a function and by Barus' constants that are the same oil, from C: films [nm], and one after a time step. */
#include <math.h>
#include <stdio.h>
#include "pyworm_contact.h"

#define N 257

static double barus(double pressure, double temperature) { return 0.04 * exp(16e-9 * pressure) + 0 * temperature; }

int main(void) {
    static double gap[N], supply[N], p[N], h[N];
    const double dx = 5e-6, pressures[5] = {0, 1e8, 3e8, 6e8, 1.5e9}, temperature = 313.15;
    const struct pyworm_options options = {.tolerance = 1e-8, .accuracy = 0.1, .most_steps = 60};
    double viscosities[5];
    struct pyworm_scene scene = {.nx = N, .ny = 1, .dx = dx, .dy = 1, .load = 1e5, .reduced_modulus = 230e9,
                                 .velocity_1 = {1, 0}, .velocity_2 = {1, 0}, .gap = gap};
    struct pyworm_oil oils[3] = {
        {.law = PYWORM_BARUS, .viscosity = 0.04, .exponent = 16e-9, .temperature = temperature},
        {.law = PYWORM_TABULATED, .temperature = temperature, .pressure_count = 5, .temperature_count = 1,
         .pressures = pressures, .temperatures = &temperature, .viscosities = viscosities},
        {.law = PYWORM_TABULATED, .temperature = temperature, .viscosity_at = barus},
    };
    const struct pyworm_fields fields = {.p = p, .h = h};
    struct pyworm_found found;
    int status;

    for (int i = 0; i < N; i++) {
        gap[i] = pow(dx * (i - 192), 2) / 0.02;
        supply[i] = 0.2e-6;
    }
    for (int i = 0; i < 5; i++) viscosities[i] = barus(pressures[i], temperature);
    for (int k = 0; k < 4; k++) {
        scene.supply = k < 3 ? NULL : supply;
        struct pyworm_film *film = pyworm_setup(&scene, &oils[k % 3], NULL, NULL, NULL, &status);
        if (status == PYWORM_OK) status = pyworm_solve(film, &options, &found);
        printf("%s %.6f\n", pyworm_message(status), 1e9 * found.film_min);
        if (k == 2) {
            scene.load = 1.5e5;
            status = pyworm_advance(film, &scene, 2e-4, &options, &found);
            scene.load = 1e5;
            printf("%s %.6f\n", pyworm_message(status), 1e9 * found.film_min);
        }
        if (pyworm_read(film, &fields) != PYWORM_OK) return 1;
        pyworm_free(film);
    }
    return 0;
}
