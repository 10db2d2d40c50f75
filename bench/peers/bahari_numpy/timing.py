"""CPU time per Picard iteration (numpy and scipy, one thread), standard and mixed, example 5.3: the fastest of some
rounds of ten iterations from phi = 0. One line per case: form, degree, cells, milliseconds."""
import os
os.environ['OMP_NUM_THREADS'] = os.environ['OPENBLAS_NUM_THREADS'] = '1'
import time
from adapt2 import *
for kind in ('std', 'mix'):
    for p in (3, 5):
        for n in (16, 32, 64, 128):
            s = (Std if kind == 'std' else Mix)(p, n)
            zero = np.zeros((s.N, s.N)) if kind == 'std' else (np.zeros((s.N, s.N-1)), np.zeros((s.N-1, s.N)), np.zeros((s.N-1, s.N-1)))
            fun = lambda a, b: 1/RHO['5.3'](a, b)
            best = 1e300
            for _ in range(7 if n < 128 else 4):
                start = time.process_time()
                st, it, r, t = picard(kind, s, zero, fun, 0., 10)
                best = min(best, (time.process_time()-start)/it)
            print(kind, p, n, '%.4f' % (1e3*best), flush=True)
