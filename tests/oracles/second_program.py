#!/usr/bin/env python3
"""Check values of the laws from a second program.

Every law is written here once more, in another language and in the form and normalisation of its source (pressure
drop, exchange coefficient or drag coefficient, with the source's own Reynolds number), from the literature and not
from the C++ headers. The numbers go to reference-data/law_checks/second_program.csv, which the tests read; running
this again is needed only for new points:

    tests/oracles/second_program.py > reference-data/law_checks/second_program.csv
"""
from math import atan, exp, inf, log, log10, pi, sqrt

G = 9.81
BED = dict(voidage=0.46, re=100.0, diameter=5e-3, particle_density=2230.0, foreign_diameter=6e-3,
           foreign_density=7800.0, density=998.2, viscosity=1e-3, superficial_velocity=0.06, settling_velocity=0.097,
           column_diameter=0.05, kinetic_energy=1e-3, foreign_kinetic_energy=1e-3, transition=0.5, impact_speed=0.1,
           roughness=1e-6)


def bisect(function, lower, upper):
    sign = function(lower) > 0
    for _ in range(200):
        middle = 0.5 * (lower + upper)
        if (function(middle) > 0) == sign:
            lower = middle
        else:
            upper = middle
    return 0.5 * (lower + upper)


# --- one sphere: drag coefficients ----------------------------------------------------------------------------------

def schiller_naumann(re):
    return 24 / re * (1 + 0.15 * re**0.687) if re <= 1000 else 0.44


def dalla_valle(re):
    return (0.63 + 4.8 / sqrt(re))**2


def brown_lawler(re):
    return 24 / re * (1 + 0.150 * re**0.681) + 0.407 / (1 + 8710 / re)


SINGLE_SPHERE = {
    'schiller-naumann-1935': schiller_naumann,
    'brown-lawler-2003': brown_lawler,
    'turton-levenspiel-1986': lambda re: 24 / re * (1 + 0.173 * re**0.657) + 0.413 / (1 + 16300 * re**-1.09),
    'haider-levenspiel-1989': lambda re: 24 / re * (1 + 0.1806 * re**0.6459) + 0.4251 / (1 + 6880.95 / re),
    'dalla-valle-1948': dalla_valle,
    'clift-gauvin-1971': lambda re: 24 / re * (1 + 0.15 * re**0.687) + 0.42 / (1 + 42500 * re**-1.16),
    'clift-gauvin-1971-refit': lambda re: 24 / re * (1 + 0.152 * re**0.677) + 0.417 / (1 + 5070 * re**-0.94),
    'abraham-1970': lambda re: 24 / 9.06**2 * (1 + 9.06 / sqrt(re))**2,
}


def terminal_velocity(coefficient, d, excess, rho, mu):
    """3/4 C_D rho u^2/d = excess, the driving force per volume."""
    return bisect(lambda u: 0.75 * coefficient(rho * d * u / mu) * rho * u * u / d - excess, 1e-12, 100.0)


# --- suspensions: beta [kg/(m3 s)] at slip w, or the total force over Stokes drag --------------------------------------

def from_pressure_drop(gradient):
    """beta from the pressure drop -dp/dz(e, U) of a fixed bed: e (-dp/dz) = beta w, U = e w."""
    def beta(e, w, d, rho, mu):
        return e * gradient(e, e * w, d, rho, mu) / w
    return beta


def ergun(viscous, inertial):
    def gradient(e, u, d, rho, mu):
        return viscous * (1 - e)**2 / e**3 * mu * u / d**2 + inertial * (1 - e) / e**3 * rho * u**2 / d
    return from_pressure_drop(gradient)


def eisfeld_schnitzlein(e, w, d, rho, mu, ratio=0.1):
    def gradient(e, u, d, rho, mu):
        a = 1 + 2 * ratio / (3 * (1 - e))
        b = (1.15 * ratio**2 + 0.87)**2
        return 154 * a**2 * (1 - e)**2 / e**3 * mu * u / d**2 + a / b * (1 - e) / e**3 * rho * u**2 / d
    return from_pressure_drop(gradient)(e, w, d, rho, mu)


def gibilaro(constant, newton):
    def gradient(e, u, d, rho, mu):
        return (constant / (rho * u * d / mu) + newton) * rho * u**2 / d * (1 - e) * e**-4.8
    return from_pressure_drop(gradient)


def wen_yu(e, w, d, rho, mu):
    re = rho * e * w * d / mu
    return 0.75 * schiller_naumann(re) * rho * e * (1 - e) * w / d * e**-2.65


def gidaspow(e, w, d, rho, mu):
    return ergun(150, 1.75)(e, w, d, rho, mu) if e <= 0.8 else wen_yu(e, w, d, rho, mu)


def gidaspow_blend(e, w, d, rho, mu):
    share = atan(150 * 1.75 * (e - 0.8)) / pi + 0.5
    return (1 - share) * ergun(150, 1.75)(e, w, d, rho, mu) + share * wen_yu(e, w, d, rho, mu)


def voidage_function(coefficient, exponent):
    """beta = 3/4 C_D rho (1 - e) e^2 w e^-x / d: C_D of one sphere on the superficial velocity U = e w."""
    def beta(e, w, d, rho, mu):
        re = rho * e * w * d / mu
        force = coefficient(re) * pi / 8 * rho * d**2 * (e * w)**2 * e**-exponent(e, re)  # on one sphere
        return force / (pi / 6 * d**3) * (1 - e) / w
    return beta


def di_felice_exponent(e, re):
    return 3.7 - 0.65 * exp(-(1.5 - log10(re))**2 / 2)


def rong_exponent(e, re):
    return 2.65 * (e + 1) - (5.3 - 3.5 * e) * e**2 * exp(-(1.5 - log10(re))**2 / 2)


def syamlal_obrien(e, w, d, rho, mu):
    re = rho * w * d / mu
    a = e**4.14
    b = 0.8 * e**1.28 if e <= 0.85 else e**2.65
    vr = 0.5 * (a - 0.06 * re + sqrt((0.06 * re)**2 + 0.12 * re * (2 * b - a) + a**2))
    cd = (0.63 + 4.8 / sqrt(re / vr))**2
    return 0.75 * cd * e * (1 - e) * rho / (vr**2 * d) * w


def from_total_force(total):
    """beta from the total force on a sphere over 3 pi mu d e w, which holds the mean pressure gradient as well."""
    def beta(e, w, d, rho, mu):
        return 18 * mu * e * (1 - e) * e * total(e, rho * e * w * d / mu) / d**2
    return beta


def hkl_low(s, constant, a, b, c):
    return (1 + 3 * sqrt(s / 2) + 135 / 64 * s * log(s) + constant * s) / (1 + a * s + b * s**2 + c * s**3)


def hkl_parts(s):
    e = 1 - s
    w = exp(-10 * (0.4 - s) / s)
    dense = 10 * s / e**3
    f0 = (1 - w) * hkl_low(s, 17.14, 0.681, -8.48, 8.16) + w * dense if s < 0.4 else dense
    f2 = (1 - w) * hkl_low(s, 17.89, 0.681, -11.03, 15.41) + w * dense if s < 0.4 else dense
    f1 = sqrt(2 / s) / 40 if s <= 0.1 else 0.11 + 5.1e-4 * exp(11.6 * s)
    f3 = 0.9351 * s + 0.03667 if s < 0.0953 else 0.0673 + 0.212 * s + 0.0232 / e**5
    onset = (f2 - 1) / (3 / 8 - f3) if s <= 0.01 else (f3 + sqrt(f3**2 - 4 * f1 * (f0 - f2))) / (2 * f1)
    return f0, f1, f2, f3, onset


def hill_koch_ladd(e, re):
    s, r = 1 - e, re / 2
    f0, f1, f2, f3, onset = hkl_parts(s)
    if r > onset:
        return f2 + f3 * r
    return 1 + 3 / 8 * r if s <= 0.01 else f0 + f1 * r**2


def koch_hill(constant):
    def total(e, re):
        s = 1 - e
        f0 = hkl_low(s, constant, 0.681, -8.48, 8.16) if s < 0.4 else 10 * s / e**3
        return f0 + (0.0673 + 0.212 * s + 0.0232 / e**5) * re / 2
    return total


def from_drag(drag):
    """beta from the drag without the pressure gradient over 3 pi mu d e w."""
    def beta(e, w, d, rho, mu):
        return 18 * mu * e * (1 - e) * drag(e, rho * e * w * d / mu) / d**2
    return beta


def beetstra(e, re):
    s = 1 - e
    return 10 * s / e**2 + e**2 * (1 + 1.5 * sqrt(s)) + 0.413 * re / (24 * e**2) * (
        1 / e + 3 * e * s + 8.4 * re**-0.343) / (1 + 10**(3 * s) * re**(-(1 + 4 * s) / 2))


def tang(e, re):
    s = 1 - e
    return 10 * s / e**2 + e**2 * (1 + 1.5 * sqrt(s)) + (
        0.11 * s * (1 + s) - 0.00456 / e**4 + (0.169 * e + 0.0644 / e**4) * re**-0.343) * re


def tenneti(e, re):
    s = 1 - e
    return (1 + 0.15 * re**0.687) / e**3 + 5.81 * s / e**3 + 0.48 * s**(1 / 3) / e**4 + s**3 * re * (
        0.95 + 0.61 * s**3 / e**2)


def tenneti_mfix(e, re):
    s = 1 - e
    return (1 + 0.15 * re**0.687) / e**3 + 5.81 * s / e**3 + 0.48 * s**(1 / 3) / e**4 + s**3 * re * (
        0.95 + 0.61 * s**(1 / 3) / e**2)


def tenneti_openfoam(e, w, d, rho, mu):
    s, re = 1 - e, rho * e * w * d / mu
    cd_re = schiller_naumann(re) * re + 24 * e**2 * (
        5.81 * s / e**3 + 0.48 * s**(1 / 3) / e**4 + s**3 * re * (0.95 + 0.61 * s**3 / e**2))
    return 0.75 * cd_re * s * mu / d**2


DRAG = {
    'ergun-1952': ergun(150, 1.75),
    'ergun-1952-refit': ergun(151.9, 1.697),
    'eisfeld-schnitzlein-2001': eisfeld_schnitzlein,
    'wen-yu-1966': wen_yu,
    'gidaspow-1994': gidaspow,
    'gidaspow-1994-blend': gidaspow_blend,
    'di-felice-1994': voidage_function(dalla_valle, di_felice_exponent),
    'di-felice-1994-mfix': voidage_function(schiller_naumann, di_felice_exponent),
    'gibilaro-1985': gibilaro(17.3, 0.336),
    'doroodchi-2012': gibilaro(18, 0.33),
    'syamlal-obrien-1993': syamlal_obrien,
    'hill-koch-ladd-2001': from_total_force(hill_koch_ladd),
    'koch-hill-2001': from_total_force(koch_hill(16.14)),
    'koch-hill-2001-ladd': from_total_force(koch_hill(17.14)),
    'beetstra-2007': from_drag(beetstra),
    'tang-2015': from_drag(tang),
    'tenneti-2011': from_total_force(tenneti),
    'tenneti-2011-mfix': from_drag(tenneti_mfix),
    'tenneti-2011-openfoam': tenneti_openfoam,
    'rong-2013': voidage_function(dalla_valle, rong_exponent),
}

# Points in the middle of every law, then points on both sides of each place where a law changes its form.
MIDDLE = [(0.42, 3.0), (0.55, 40.0), (0.70, 250.0), (0.88, 700.0)]
SN_SIDES = [(0.5, 995.0), (0.5, 1005.0)]
SPECIAL = {
    'wen-yu-1966': SN_SIDES,
    'gidaspow-1994': [(0.796, 200.0), (0.804, 200.0)],
    'gidaspow-1994-blend': [(0.79, 300.0), (0.805, 300.0)],
    'di-felice-1994': [(0.4, 0.005), (0.4, 0.015)],
    'di-felice-1994-mfix': SN_SIDES + [(0.4, 0.005)],
    'syamlal-obrien-1993': [(0.846, 100.0), (0.854, 100.0)],
    'koch-hill-2001': [(0.597, 50.0), (0.603, 50.0), (0.995, 20.0)],
    'koch-hill-2001-ladd': [(0.597, 50.0), (0.603, 50.0)],
    'rong-2013': [(0.4, 0.005), (0.4, 0.015)],
    'tenneti-2011-openfoam': SN_SIDES,
    # s around 0.4 (creeping), 0.1 (F1), 0.0953 (F3) and 0.01 (the dilute form), in the small-Re form and the large.
    'hill-koch-ladd-2001': [(e, re) for e in (0.597, 0.603, 0.8995, 0.9005, 0.9043, 0.9051, 0.98995, 0.99005)
                            for re in (0.5, 100.0)] +
                           # and R around the onset of the large-Re form
                           [(e, 2 * f * hkl_parts(1 - e)[4]) for e in (0.7, 0.93, 0.992) for f in (0.995, 0.99999, 1.00001, 1.005)],
}


# --- bed ------------------------------------------------------------------------------------------------------------

def archimedes(d, rp, rho, mu):
    return d**3 * rho * (rp - rho) * G / mu**2


def minimum_fluidisation(gradient):
    """The velocity at which the pressure drop of the bed carries its weight."""
    def velocity(a):
        weight = (1 - a['voidage']) * (a['particle_density'] - a['density']) * G
        return bisect(lambda u: gradient(a['voidage'], u, a['diameter'], a['density'], a['viscosity']) - weight, 1e-12, 10)
    return velocity


def wen_yu_minimum(a):
    re = sqrt(33.7**2 + 0.0408 * archimedes(a['diameter'], a['particle_density'], a['density'], a['viscosity'])) - 33.7
    return re * a['viscosity'] / (a['density'] * a['diameter'])


MINIMUM = {
    'ergun-1952-minimum-fluidisation': minimum_fluidisation(
        lambda e, u, d, rho, mu: 150 * (1 - e)**2 / e**3 * mu * u / d**2 + 1.75 * (1 - e) / e**3 * rho * u**2 / d),
    'wen-yu-1966-minimum-fluidisation': wen_yu_minimum,
    'doroodchi-2012-minimum-fluidisation': minimum_fluidisation(
        lambda e, u, d, rho, mu: (18 * mu * u / d**2 + 0.33 * rho * u**2 / d) * (1 - e) / e**4.8),
    'gibilaro-1985-minimum-fluidisation': minimum_fluidisation(
        lambda e, u, d, rho, mu: (17.3 * mu * u / d**2 + 0.336 * rho * u**2 / d) * (1 - e) / e**4.8),
}


def bed_terminal(a):
    excess = (a['particle_density'] - a['density']) * G
    return terminal_velocity(brown_lawler, a['diameter'], excess, a['density'], a['viscosity'])


def richardson_zaki(re, ratio):
    if re < 0.2:
        return 4.65 + 19.5 * ratio
    if re < 1:
        return (4.35 + 17.5 * ratio) * re**-0.03
    if re < 200:
        return (4.45 + 18 * ratio) * re**-0.1
    return 4.45 * re**-0.1 if re < 500 else 2.39


def between(upper, lower, x):
    """n of (upper - n)/(n - lower) = x."""
    return (upper + lower * x) / (1 + x)


EXPONENT = {
    'richardson-zaki-1954': lambda re, ar, ratio: richardson_zaki(re, ratio),
    'khan-richardson-1989': lambda re, ar, ratio: between(4.8, 2.4, 0.043 * ar**0.57 * (1 - 1.24 * ratio**0.27)),
    'khan-richardson-1989-codes': lambda re, ar, ratio: between(4.8, 2.4, 0.043 * ar**0.57 * (1 - 2.4 * ratio**0.27)),
    'rowe-1987': lambda re, ar, ratio: 2.35 * (2 + 0.175 * re**0.75) / (1 + 0.175 * re**0.75),
    'garside-al-dibouni-1977': lambda re, ar, ratio: between(5.09, 2.73, 0.104 * re**0.877),
}
WALL = {
    # The source gives the drag over Stokes drag.
    'haberman-sayre-1958': lambda r: 1 / ((1 - 0.75857 * r**5) / (1 - 2.1050 * r + 2.0865 * r**3 - 1.7068 * r**5
                                                                   + 0.72603 * r**6)),
    'munroe-1888': lambda r: 1 - r**1.5,
    'newton-1687': lambda r: (1 - r * r) * sqrt(1 - r * r / 2),
    'richardson-zaki-1954-wall': lambda r: exp(-log(10) * r),
}


# --- foreign sphere -------------------------------------------------------------------------------------------------

def mixture(a):
    return a['voidage'] * a['density'] + (1 - a['voidage']) * a['particle_density']


def foreign_terminal(a):
    excess = (a['foreign_density'] - a['density']) * G
    return terminal_velocity(brown_lawler, a['foreign_diameter'], excess, a['density'], a['viscosity'])


def foreign_exponent(a):
    return richardson_zaki(a['density'] * foreign_terminal(a) * a['foreign_diameter'] / a['viscosity'], 0)


def kennedy_bretton(a):
    return foreign_terminal(a) * a['voidage']**(foreign_exponent(a) - 1) - a['superficial_velocity'] / a['voidage']


def galvin(a):
    share = (a['foreign_density'] - mixture(a)) / (a['foreign_density'] - a['density'])
    return foreign_terminal(a) * share**(foreign_exponent(a) - 1) - a['superficial_velocity'] / a['voidage']


def kunii_levenspiel(a):
    rho = mixture(a)
    return sqrt(4 * G * a['foreign_diameter'] * (a['foreign_density'] - rho) / (3 * 0.44 * rho)) - a['superficial_velocity']


def joshi(a):
    d, rho, mu = a['foreign_diameter'], a['density'], a['viscosity']
    left = (a['foreign_density'] - rho) * G * a['voidage']**4.8
    w = bisect(lambda w: 18 * mu * w / d**2 + 0.33 * rho * w * w / d - left, 0.0, 10.0)
    return (w - a['superficial_velocity']) / a['voidage']


def di_felice_pseudo_fluid(a):
    rho, u, d1 = mixture(a), a['superficial_velocity'], a['diameter']
    drive = (a['particle_density'] - rho) * G
    mu = bisect(lambda m: 0.75 * dalla_valle(rho * u * d1 / m) * rho * u * u / d1 - drive, 1e-9, 100.0)
    fall = terminal_velocity(dalla_valle, a['foreign_diameter'], (a['foreign_density'] - rho) * G, rho, mu)
    return fall - u


def foreign_drag(a, slip):
    """Drag on the foreign sphere per volume; 0 at rest."""
    d, rho = a['foreign_diameter'], a['density']
    return 0.75 * brown_lawler(rho * d * slip / a['viscosity']) * rho * slip**2 / d if slip > 0 else 0.0


def van_der_wielen(a):
    up = a['superficial_velocity'] / a['voidage']
    rate = 10.5 * (a['diameter'] / a['foreign_diameter'])**0.95 * (1 - a['voidage'])
    weight = a['foreign_density'] * G
    return bisect(lambda v: 1 - mixture(a) / a['foreign_density'] - foreign_drag(a, v + up) / weight - rate * v, -up, 50.0)


def grbavcic_force(a, reading):
    f, e, ratio = a['transition'], a['voidage'], a['foreign_diameter'] / a['diameter']
    effective = (1 - f) * a['density'] + f * mixture(a)
    k = 2.2 * e**5.07 * ratio**-1.48 * (mixture(a) / effective)**2.47
    d, u = (a['foreign_diameter'], foreign_terminal(a)) if reading == 'foreign' else (a['diameter'], bed_terminal(a))
    force = k * (1 - f) * (1 - e) * ratio**3 * 0.5 * a['density'] * pi / 4 * d**2 * u**2
    return force / (a['foreign_density'] * pi / 6 * a['foreign_diameter']**3 * G)


def grbavcic(reading):
    def velocity(a):
        f = a['transition']
        effective = (1 - f) * a['density'] + f * mixture(a)
        net = (a['foreign_density'] * (1 - grbavcic_force(a, reading)) - effective) * G
        slip = bisect(lambda w: foreign_drag(a, w) - net, 1e-12, 50.0)
        return slip - a['superficial_velocity'] / a['voidage']
    return velocity


CLASSIFICATION = {
    'kennedy-bretton-1966': kennedy_bretton,
    'kunii-levenspiel-1969': kunii_levenspiel,
    'joshi-1983-reconstruction': joshi,
    'di-felice-1991': di_felice_pseudo_fluid,
    'van-der-wielen-1996': van_der_wielen,
    'grbavcic-2009': grbavcic('foreign'),
    'grbavcic-2009-bed': grbavcic('bed'),
    'galvin-1999': galvin,
}
FORCE = {
    'peng-2014': lambda a: 1.08 + 0.26 * a['voidage'] - 1.34 * a['voidage']**2,
    'van-der-wielen-1996-force': lambda a: 10.5 * (a['diameter'] / a['foreign_diameter'])**0.95 * (1 - a['voidage']) *
                                           a['settling_velocity'],
    'grbavcic-2009-force': lambda a: grbavcic_force(a, 'foreign'),
    'grbavcic-2009-force-bed': lambda a: grbavcic_force(a, 'bed'),
}


# --- collisions -----------------------------------------------------------------------------------------------------

def carnahan_starling(s):
    return 1 / (1 - s) + 3 * s / (2 * (1 - s)**2) + s**2 / (2 * (1 - s)**3)


def lun_savage(s):
    return (1 - s / 0.575)**(-2.5 * 0.575)


CONTACT = {
    'lun-savage-1986': lun_savage,
    'sinclair-jackson-1989': lambda s: 1 / (1 - (s / 0.575)**(1 / 3)),
    'ding-gidaspow-1990': lambda s: 3 / 5 / (1 - (s / 0.575)**(1 / 3)),
    'carnahan-starling-1969': carnahan_starling,
    'ma-ahmadi-1986': lambda s: (1 + 2.5 * s + 4.5094 * s**2 + 4.515439 * s**3) / (1 - (s / 0.64356)**3)**0.678021,
    'torquato-1995': lambda s: carnahan_starling(s) if s <= 0.494 else
                               carnahan_starling(0.494) * (0.64 - 0.494) / (0.64 - s),
    # Foreign sphere 6 mm in 5 mm: sum of s_i/d_i is s/5.
    'lebowitz-1964': lambda s: 1 / (1 - s) + 3 * s / 5 * 5 * 6 / ((1 - s)**2 * (5 + 6)),
}


def frequency(a, relative_speed):
    """Swept volume per time: n pi d12^2 times the mean relative speed."""
    s, d1, d12 = 1 - a['voidage'], a['diameter'], 0.5 * (a['diameter'] + a['foreign_diameter'])
    return 6 * s / (pi * d1**3) * pi * d12**2 * relative_speed


def maxwell(q1, q2):
    """Mean relative speed of Maxwellian spheres with one-component variances 2/3 q."""
    return sqrt(8 / pi * 2 / 3 * (q1 + q2))


FREQUENCY = {
    'simonin-1991': lambda a: frequency(dict(a, foreign_diameter=a['diameter']),
                                        maxwell(a['kinetic_energy'], a['kinetic_energy'])) * lun_savage(1 - a['voidage']),
    'gidaspow-1994-collision-frequency': lambda a: frequency(a, maxwell(a['kinetic_energy'], a['kinetic_energy'])) *
                                                   lun_savage(1 - a['voidage']),
    'gidaspow-1994-unequal-fluctuations':
        lambda a: frequency(a, maxwell(a['kinetic_energy'], a['foreign_kinetic_energy'])) * lun_savage(1 - a['voidage']),
    'gjaltema-1997': lambda a: frequency(a, a['settling_velocity']),
}


def legendre(a):
    stokes = (a['particle_density'] + 0.5 * a['density']) * a['impact_speed'] * a['diameter'] / (9 * a['viscosity'])
    return exp(-35 / stokes)


def barnocky_davis(a):
    stokes = a['particle_density'] * a['impact_speed'] * a['diameter'] / (9 * a['viscosity'])
    return max(0, 1 + log(2 * a['roughness'] / a['diameter']) / stokes)


RESTITUTION = {'legendre-2005': legendre, 'barnocky-davis-1988': barnocky_davis}


# --- table ----------------------------------------------------------------------------------------------------------

def row(law, arguments, quantity, value):
    words = ' '.join(f'{name}={value!r}' for name, value in arguments.items())
    print(f'{law},{words},{quantity},{value:#.8g},second program')


def rows(laws, quantity, points):
    for law, function in laws.items():
        for point in points:
            row(law, point, quantity, function(dict(BED, **point)))


def main():
    print('# Written by tests/oracles/second_program.py: law,arguments,quantity,value,origin')
    water = {name: BED[name] for name in ('diameter', 'density', 'viscosity')}
    for law, beta in DRAG.items():
        for e, re in MIDDLE + SPECIAL.get(law, []):
            re = float(f'{re:.9g}')
            d, rho, mu = water['diameter'], water['density'], water['viscosity']
            w = re * mu / (rho * e * d)
            row(law, dict(voidage=e, re=re), 'beta', beta(e, w, d, rho, mu))
    # One liquid and sphere unlike the defaults.
    other = dict(diameter=3e-3, density=1800.0, viscosity=1.8e-3)
    re, e = 250.0, 0.55
    w = re * other['viscosity'] / (other['density'] * e * other['diameter'])
    b = gidaspow(e, w, other['diameter'], other['density'], other['viscosity'])
    point = dict(voidage=e, re=re, **other)
    row('gidaspow-1994', point, 'beta', b)
    row('gidaspow-1994', point, 'slip_velocity', w)
    row('gidaspow-1994', point, 'drag_force', pi / 6 * other['diameter']**3 * b * w / (1 - e))
    for law, coefficient in SINGLE_SPHERE.items():
        for re in (0.5, 30.0, 800.0, 995.0, 1005.0, 5000.0, 1e5):
            row(law, dict(re=re), 'drag_coefficient', coefficient(re))
        for d, rp, rho, mu in ((5e-3, 2230.0, 998.2, 1e-3), (3e-3, 7800.0, 1800.0, 1.8e-3)):
            row(law, dict(re=1.0, diameter=d, particle_density=rp, density=rho, viscosity=mu), 'terminal_velocity',
                terminal_velocity(coefficient, d, (rp - rho) * G, rho, mu))
    rows(MINIMUM, 'minimum_fluidisation_velocity',
         [dict(voidage=0.40), dict(voidage=0.425, diameter=1e-3), dict(voidage=0.40, diameter=1e-4)])
    # Spheres whose terminal Reynolds number lies on both sides of every branch of Richardson and Zaki.
    for target in (0.1, 0.1985, 0.2015, 0.6, 0.994, 1.006, 30.0, 198.8, 201.2, 350.0, 497.0, 503.0, 2000.0):
        d = bisect(lambda d: 998.2 * d * bed_terminal(dict(BED, diameter=d)) / 1e-3 - target, 1e-6, 0.05)
        d = float(f'{d:.7g}')
        for column in (0.5, 0.05):
            point = dict(diameter=d, column_diameter=column)
            a = dict(BED, **point)
            re = 998.2 * d * bed_terminal(a) / 1e-3
            for law, exponent in EXPONENT.items():
                if law == 'richardson-zaki-1954' or target in (0.6, 30.0, 350.0):
                    row(law, point, 'expansion_exponent', exponent(re, archimedes(d, 2230.0, 998.2, 1e-3), d / column))
    for law, correction in WALL.items():
        for column in (0.05, 0.02, 0.01):
            row(law, dict(column_diameter=column), 'velocity_ratio', correction(5e-3 / column))
    bed = [dict(voidage=0.46, superficial_velocity=0.06), dict(voidage=0.7, superficial_velocity=0.15),
           dict(voidage=0.55, superficial_velocity=0.05, diameter=3e-3, foreign_diameter=4e-3, foreign_density=4000.0,
                density=1800.0, viscosity=1.8e-3)]
    rows(CLASSIFICATION, 'settling_velocity', bed)
    # A fine foreign sphere, whose exponent would depend on walls.
    rows({law: CLASSIFICATION[law] for law in ('kennedy-bretton-1966', 'galvin-1999')}, 'settling_velocity',
         [dict(voidage=0.6, superficial_velocity=0.01, foreign_diameter=5e-4, foreign_density=2600.0)])
    rows({law: CLASSIFICATION[law] for law in ('grbavcic-2009', 'grbavcic-2009-bed')}, 'settling_velocity',
         [dict(voidage=0.5, superficial_velocity=0.07, transition=f) for f in (0.0, 0.3, 0.9)])
    rows(FORCE, 'force_over_weight', [dict(voidage=0.46), dict(voidage=0.7, settling_velocity=0.25, diameter=3e-3)])
    rows({law: FORCE[law] for law in ('grbavcic-2009-force', 'grbavcic-2009-force-bed')}, 'force_over_weight',
         [dict(voidage=0.6, transition=f) for f in (0.0, 0.3, 0.9)])
    rows(CONTACT_BY_VOIDAGE, 'contact_value',
         [dict(voidage=1 - s) for s in (0.05, 0.3, 0.45, 0.492, 0.496, 0.55)])
    rows(FREQUENCY, 'collision_frequency',
         [dict(voidage=0.6), dict(voidage=0.8, diameter=3e-3, kinetic_energy=4e-3, foreign_kinetic_energy=5e-4,
                                  settling_velocity=0.3)])
    rows(RESTITUTION, 'restitution_over_dry',
         [dict(impact_speed=0.1), dict(impact_speed=0.5, diameter=3e-3, roughness=1e-5, viscosity=5e-3)])


CONTACT_BY_VOIDAGE = {law: (lambda a, g0=g0: g0(1 - a['voidage'])) for law, g0 in CONTACT.items()}

if __name__ == '__main__':
    main()
