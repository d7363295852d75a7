#!/usr/bin/env python3
"""Check values of the laws from the Python library fluids (Debian package python3-fluids, 1.0.22).

The numbers go to reference-data/law_checks/fluids.csv, which the tests read, so that neither building nor testing needs
the library:

    tests/oracles/fluids_values.py > reference-data/law_checks/fluids.csv
"""
import fluids
from fluids.drag import Clift_Gauvin, Haider_Levenspiel, v_terminal
from fluids.packed_bed import Ergun

METHODS = {'haider-levenspiel-1989': ('Haider_Levenspiel', Haider_Levenspiel),
           'clift-gauvin-1971-refit': ('Clift_Gauvin', Clift_Gauvin)}


def row(law, arguments, quantity, value, call):
    words = ' '.join(f'{name}={argument!r}' for name, argument in arguments.items())
    print(f'{law},{words},{quantity},{value:#.9g},fluids {fluids.__version__},{call}')


def main():
    print('# Written by tests/oracles/fluids_values.py: law,arguments,quantity,value,origin,call')
    for law, (method, coefficient) in METHODS.items():
        for re in (0.01, 1.0, 200.0, 1e4, 1e5):
            row(law, dict(re=re), 'drag_coefficient', coefficient(re), coefficient.__name__)
        # 70 um is the example of the library's documentation.
        for d, rp, rho, mu in ((70e-6, 2600.0, 1000.0, 1e-3), (5e-3, 2230.0, 998.2, 1e-3), (6e-3, 7800.0, 1800.0, 1.8e-3)):
            velocity = v_terminal(D=d, rhop=rp, rho=rho, mu=mu, Method=method)
            # The library takes g = 9.80665 m/s2: the sphere that feels the same force at 9.81.
            equivalent = rho + (rp - rho) * 9.80665 / 9.81
            row(law, dict(re=1.0, diameter=d, particle_density=equivalent, density=rho, viscosity=mu), 'terminal_velocity',
                velocity, 'v_terminal')
    # Exchange coefficient from the pressure drop over 1 m: beta = e dp/w at w = U/e. The first is the documentation's.
    for d, e, u, rho, mu in ((8e-4, 0.4, 1e-3, 1e3, 1e-3), (5e-3, 0.4, 0.04, 998.2, 1e-3), (3e-3, 0.45, 0.02, 1800.0, 1.8e-3)):
        beta = e * e * Ergun(dp=d, voidage=e, vs=u, rho=rho, mu=mu, L=1.0) / u
        row('ergun-1952', dict(voidage=e, re=rho * u * d / mu, diameter=d, density=rho, viscosity=mu), 'beta', beta, 'Ergun')


if __name__ == '__main__':
    main()
