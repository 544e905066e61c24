/* A motion with stops and damping from rest until it repeats, by CVODE (SUNDIALS; Debian: libsundials-dev):
 * slides are integrated with root finding on the velocity, the end of a stop is its arcsine.
 * Usage: sticking OMEGA ALPHA ZETA RTOL REFERENCE RUNS. Prints the least time of the runs in microseconds and
 * the relative error of the maximum displacement. */
#include <cvode/cvode.h>
#include <math.h>
#include <nvector/nvector_serial.h>
#include <stdio.h>
#include <stdlib.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>
#include <time.h>

typedef struct { double omega, alpha, zeta, direction; } Motion;

static int slope(double t, N_Vector y, N_Vector rate, void *data) {
    Motion *m = data;
    double *at = NV_DATA_S(y), *out = NV_DATA_S(rate);
    out[0] = at[1];
    out[1] = m->alpha * sin(m->omega * t) - at[0] - 2 * m->zeta * at[1] - m->direction;
    return 0;
}

static int velocity(double t, N_Vector y, double *out, void *data) {
    (void)t, (void)data;
    out[0] = NV_Ith_S(y, 1);
    return 0;
}

/* From rest at x: when the body slides, and which way. */
static double released(Motion *m, double t, double x) {
    double force = m->alpha * sin(m->omega * t) - x;
    if (fabs(force) > 1) {
        m->direction = force > 0 ? 1 : -1;
        return t;
    }
    double now = m->omega * t, first = INFINITY;
    for (int s = 1; s >= -1; s -= 2) {
        double y = (x + s) / m->alpha;
        if (fabs(y) >= 1) continue;
        double angle = s > 0 ? asin(y) : M_PI - asin(y);
        angle += ceil((now - angle) / (2 * M_PI)) * 2 * M_PI;
        if (angle <= now) angle += 2 * M_PI;
        if (angle < first) {
            first = angle;
            m->direction = s;
        }
    }
    return first / m->omega;
}

static double seconds(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return t.tv_sec + 1e-9 * t.tv_nsec;
}

int main(int count, char **argument) {
    if (count < 7) return 2;
    Motion m = {atof(argument[1]), atof(argument[2]), atof(argument[3]), 1};
    double rtol = atof(argument[4]), reference = atof(argument[5]), best = INFINITY, most = 0;
    SUNContext context;
    if (SUNContext_Create(NULL, &context)) return 1;
    N_Vector y = N_VNew_Serial(2, context);
    NV_Ith_S(y, 0) = NV_Ith_S(y, 1) = 0;
    void *solver = CVodeCreate(CV_ADAMS, context);
    CVodeInit(solver, slope, 0, y);
    CVodeSStolerances(solver, rtol, rtol / 100);
    CVodeSetUserData(solver, &m);
    CVodeSetNonlinearSolver(solver, SUNNonlinSol_FixedPoint(y, 0, context));
    CVodeRootInit(solver, 1, velocity);
    CVodeSetMaxNumSteps(solver, 1000000);
    CVodeSetMaxHnilWarns(solver, -1);
    int turns = 0;
    for (int run = atoi(argument[6]); run > 0; run--) {
        double begin = seconds(), t = 0, x = 0, before = -INFINITY, turn = 2 * M_PI / m.omega;
        most = -INFINITY;
        /* The greatest displacement of each turn of the drive, until two are the same to 1e-12. */
        for (turns = 1; turns < 2000;) {
            t = released(&m, t, x);
            NV_Ith_S(y, 0) = x;
            NV_Ith_S(y, 1) = 0;
            CVodeReInit(solver, t, y);
            int towards = -(int)m.direction;
            CVodeSetRootDirection(solver, &towards);
            if (CVode(solver, t + 4 * turn, y, &t, CV_NORMAL) != CV_ROOT_RETURN) return 1;
            x = NV_Ith_S(y, 0);
            if (t > turns * turn) {
                if (fabs(most - before) < 1e-12 * (1 + most)) break;
                before = most;
                most = -INFINITY;
                turns = (int)(t / turn) + 1;
            }
            most = fmax(most, x);
        }
        best = fmin(best, seconds() - begin);
    }
    printf("%.2f\t%.1e\n", best * 1e6, fabs(most / reference - 1));
    return 0;
}
