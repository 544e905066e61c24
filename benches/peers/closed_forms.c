/* The closed forms as a C programmer would write them, over arrays: {Delta0, eq. 61, A1}, and those with {V0, t1}.
 * {Delta0, the border at the turning point, A1} with a damping ratio of 2 % have a kernel of their own. Built twice: plainly, and with -ffast-math and the vector mathematics library. Usage: closed_forms POINTS, a file of
 * doubles, all frequency ratios and then all force ratios. Prints the best of many runs. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#define HALF_PI 1.57079632679489661923
/* A cosine as a shifted sine keeps the compiler from merging the two into one call, which has no vector form. */
#ifdef VECTOR
#define COS(x) sin((x) + HALF_PI)
#define NAME "gcc -O3 -ffast-math, libmvec"
#else
#define COS(x) cos(x)
#define NAME "C scalar, gcc -O2"
#endif

typedef struct { double delta, tangent, secant, omega; } Cycle;
typedef struct { double step, velocity; } Step;

/* One third-order step towards the greatest velocity, and the velocity where it leads. */
static inline Step householder(Cycle c, double psi) {
    double s = sin(psi), k = COS(psi), so = sin(c.omega * psi), ko = COS(c.omega * psi);
    double w2 = c.omega * c.omega;
    double v = c.omega * c.delta * ko + c.secant * s - c.tangent * so;
    double d1 = c.secant * k - c.omega * c.tangent * ko - w2 * c.delta * so;
    double f = (w2 - 1) * c.secant;
    double d2 = f * s - w2 * v, d3 = f * k - w2 * d1, d4 = -f * s - w2 * d2;
    double n = -d1 / d2, e = d3 / d2 * n;
    double h = n * (1 + e / 2) / (1 + e + d4 / d2 * n * n / 6);
    Step r = {h, v + h * (d1 + h / 2 * (d2 + h / 3 * d3))};
    return r;
}

__attribute__((noinline)) void triple(size_t n, const double *restrict omega, const double *restrict alpha,
                                      double *restrict delta, double *restrict border, double *restrict size) {
#pragma omp simd
    for (size_t i = 0; i < n; i++) {
        double w = omega[i], a = alpha[i], t = tan(HALF_PI / w) / w, q = 1 - w * w, r = a / q;
        double d = sqrt(r * r - t * t);
        delta[i] = d;
        border[i] = fabs(q) * sqrt(1 / (w * w) + w * w * t * t) / w;
        size[i] = 8 * d / (a * a);
    }
}

__attribute__((noinline)) void damped(size_t n, const double *restrict omega, const double *restrict alpha,
                                      double *restrict delta, double *restrict border, double *restrict size) {
#pragma omp simd
    for (size_t i = 0; i < n; i++) {
        double w = omega[i], a = alpha[i], zeta = 0.02, d = sqrt(1 - zeta * zeta), t = 2 * HALF_PI / w;
        double e = exp(-zeta * t), s = e * sin(d * t), k = e * COS(d * t), norm = (1 + e * e) / 2 + k;
        double shift = ((1 - e * e) / 2 - zeta / d * s) / norm, h = s / (d * w * norm);
        double lag = 2 * zeta * w, square = (1 - w) * (1 + w) * (1 - w) * (1 + w) + lag * lag;
        double held = (1 + shift + lag * h) / (w * w), far = sqrt(a * a / square - h * h) - shift;
        delta[i] = far;
        border[i] = sqrt(square * (held * held + h * h));
        size[i] = 8 * far / (a * a);
    }
}

static inline void five_at(double w, double a, double start, double *delta, double *border, double *size, double *velocity,
                           double *phase) {
    double b = HALF_PI / w, secant = 1 / COS(b), t = sin(b) * secant, q = 1 - w * w, r = a / q, u = t / w;
    double d = sqrt(r * r - u * u), sign = q > 0 ? 1 : -1;
    *delta = d;
    *border = fabs(q) * sqrt(1 + w * w * t * t) / (w * w);
    *size = 8 * d / (a * a);
    Cycle c = {d, t, secant, w};
    double psi = start;
    if (start == 0) {
        double d1 = secant - w * t, d2 = -w * w * w * d, d3 = (w * w - 1) * secant - w * w * d1, d4 = -w * w * d2;
        double n = -d1 / d2, e = d3 / d2 * n;
        psi = n * (1 + e / 2) / (1 + e + d4 / d2 * n * n / 6);
    }
    psi += householder(c, psi).step;
    Step last = householder(c, psi);
    *velocity = last.velocity;
    *phase = atan2(sign * d, sign * u) - HALF_PI - w * (psi + last.step);
}

/* Below 1/2 the velocity can have several maxima: the best of sixteen points to start from. */
static double scan(double w, double a) {
    double b = HALF_PI / w, secant = 1 / cos(b), t = tan(b), r = a / (1 - w * w), d = sqrt(r * r - t * t / (w * w));
    double best = -INFINITY, at = 0;
    for (int j = 0; j < 16; j++) {
        double psi = b * ((2 * j + 1) / 16.0 - 1);
        double v = w * d * cos(w * psi) + secant * sin(psi) - t * sin(w * psi);
        if (v > best) { best = v; at = psi; }
    }
    return at;
}

__attribute__((noinline)) void five(size_t n, const double *restrict omega, const double *restrict alpha,
                                    double *restrict delta, double *restrict border, double *restrict size,
                                    double *restrict velocity, double *restrict phase) {
#ifdef VECTOR
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        five_at(omega[i], alpha[i], 0, delta + i, border + i, size + i, velocity + i, phase + i);
    for (size_t i = 0; i < n; i++)
        if (omega[i] < 0.5)
            five_at(omega[i], alpha[i], scan(omega[i], alpha[i]), delta + i, border + i, size + i, velocity + i, phase + i);
#else
    for (size_t i = 0; i < n; i++)
        five_at(omega[i], alpha[i], omega[i] < 0.5 ? scan(omega[i], alpha[i]) : 0, delta + i, border + i, size + i,
                velocity + i, phase + i);
#endif
}

static double now(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return t.tv_sec + 1e-9 * t.tv_nsec;
}

int main(int count, char **arguments) {
    FILE *file = count > 1 ? fopen(arguments[1], "rb") : NULL;
    if (!file) return 2;
    fseek(file, 0, SEEK_END);
    size_t n = ftell(file) / 16;
    rewind(file);
    double *points = malloc(16 * n), *out = calloc(5 * n, 8);
    if (fread(points, 16, n, file) != n) return 2;
    double best[3] = {INFINITY, INFINITY, INFINITY};
    for (int run = 0; run < 60; run++) {
        double start = now();
        triple(n, points, points + n, out, out + n, out + 2 * n);
        double middle = now();
        five(n, points, points + n, out, out + n, out + 2 * n, out + 3 * n, out + 4 * n);
        double end = now();
        best[0] = fmin(best[0], middle - start);
        damped(n, points, points + n, out, out + n, out + 2 * n);
        double last = now();
        best[1] = fmin(best[1], end - middle);
        best[2] = fmin(best[2], last - end);
    }
    const char *kernels[3] = {"triple", "five", "damped"};
    for (int i = 0; i < 3; i++) printf("%s\t%s\t%.2f\n", NAME, kernels[i], best[i] / n * 1e9);
    return out[n / 2] == 0;
}
