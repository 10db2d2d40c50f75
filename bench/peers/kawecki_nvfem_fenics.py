"""The nonvariational finite element method of Kawecki, Lakkis, Pryer (2018) with gradient recovery, (78), by Newton's
method (84), degree 1, in FEniCS: the unit disk to an ellipse with uniform densities, u = x^2 + 3 y^2/2 - 5/8.

usage: kawecki_nvfem_fenics.py N [--tol T] [--solver mumps|umfpack|superlu]

UnitDiscMesh with N rings; U, both components of G, three of H and the multiplier are unknowns of one sparse system,
which is factorised in each step. The sign of the boundary term is that of (76) and (78); with that of (84) Newton's
method does not converge. Prints a line of JSON; newton_cpu_s counts the assembly and the solves of the Newton steps
only, cpu_s also mesh, spaces and the start. Forms are compiled before."""
import argparse
import json
import resource
import time

from dolfin import *

set_log_level(LogLevel.ERROR)
parameters["form_compiler"]["quadrature_degree"] = 4


def solve_transport(n, tolerance, solver, limit=20):
    begin = time.process_time()
    mesh = UnitDiscMesh.create(MPI.comm_world, n, 1, 2)
    element, real = FiniteElement("CG", mesh.ufl_cell(), 1), FiniteElement("R", mesh.ufl_cell(), 0)
    space = FunctionSpace(mesh, MixedElement([element] * 6 + [real]))
    w = Function(space)
    u, g1, g2, h11, h12, h22, c = split(w)
    v, s1, s2, x11, x12, x22, kappa = TestFunctions(space)
    normal = FacetNormal(mesh)
    g = as_vector([g1, g2])
    scale = Constant(3.0)  # with which grad b = -(cof D^2 u) n
    b = scale * (1 - g1 ** 2 / 4 - g2 ** 2 / 9)
    residual = dot(g - grad(u), as_vector([s1, s2])) * dx + (h11 * x11 + h22 * x22 + h12 * x12) * dx
    residual += (g1 * x11.dx(0) + g2 * x22.dx(1) + 0.5 * (g1 * x12.dx(1) + g2 * x12.dx(0))) * dx
    residual -= (g1 * normal[0] * x11 + g2 * normal[1] * x22 + 0.5 * (g1 * normal[1] + g2 * normal[0]) * x12) * ds
    residual += (h11 * h22 - h12 * h12 - Constant(6.0)) * v * dx + b * v * ds + c * v * dx + u * kappa * dx
    jacobian = derivative(residual, w)
    assign_start(mesh, space, w)
    start = time.process_time()
    update, steps = Function(space), 0
    vector = assemble(residual)
    while steps < limit:
        solve(assemble(jacobian), update.vector(), -vector, solver)
        w.vector().axpy(1.0, update.vector())
        steps += 1
        vector = assemble(residual)
        if vector.norm("linf") < tolerance:
            break
    end = time.process_time()
    error = errornorm(Expression("x[0]*x[0] + 1.5*x[1]*x[1] - 0.625", degree=2), w.split(deepcopy=True)[0], "L2", 1)
    return dict(unknowns=space.dim(), steps=steps, residual=vector.norm("linf"), l2_error=error,
                newton_cpu_s=end - start, cpu_s=end - begin)


def assign_start(mesh, space, w):
    """u = |x|^2/2, whose gradient and Hessian are recovered."""
    scalar = FunctionSpace(mesh, "CG", 1)
    v, normal = TestFunction(scalar), FacetNormal(mesh)
    mass = LUSolver(assemble(TrialFunction(scalar) * v * dx))
    u = interpolate(Expression("0.5*(x[0]*x[0] + x[1]*x[1])", degree=2), scalar)

    def project_onto(form):
        f = Function(scalar)
        mass.solve(f.vector(), assemble(form))
        return f

    g = [project_onto(u.dx(i) * v * dx) for i in range(2)]

    def hessian(i, j):
        return -0.5 * (g[i] * v.dx(j) + g[j] * v.dx(i)) * dx + 0.5 * (g[i] * normal[j] + g[j] * normal[i]) * v * ds

    h = [project_onto(hessian(i, j)) for i, j in ((0, 0), (0, 1), (1, 1))]
    real = FunctionSpace(mesh, "R", 0)
    FunctionAssigner(space, [scalar] * 6 + [real]).assign(w, [u, *g, *h, Function(real)])


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("n", type=int)
    parser.add_argument("--tol", type=float, default=1e-10)
    parser.add_argument("--solver", default="mumps")
    choice = parser.parse_args()
    solve_transport(2, choice.tol, choice.solver)
    result = solve_transport(choice.n, choice.tol, choice.solver)
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024
    print(json.dumps(dict(prog="kawecki_nvfem_fenics", n=choice.n, solver=choice.solver, peak_bytes=peak, **result)))


if __name__ == "__main__":
    main()
