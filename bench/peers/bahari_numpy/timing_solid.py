"""CPU time per Picard iteration in three dimensions (numpy and scipy, one thread), standard and mixed, examples 5.2 and
7.2, p = 3: of eight iterations. One line per case: form, degree, cells, milliseconds."""
import os
os.environ['OMP_NUM_THREADS'] = os.environ['OPENBLAS_NUM_THREADS'] = '1'
import time
from bfo3d import mix3, std3


def seconds(solve, n, iterations):
    start = time.process_time()
    solve(3, n, 27., maxit=iterations, tol=0)
    return time.process_time() - start


for solve, form in ((std3, 'std3'), (mix3, 'mix3')):
    for n in (16, 32):
        print(form, 3, n, '%.3f' % ((seconds(solve, n, 10) - seconds(solve, n, 2)) / 8 * 1e3), flush=True)
