# Gradient and Hessian by differences of the fourth order.
differences <- function(f, x, h) {
  k <- length(x); unit <- function(i) replace(numeric(k), i, h); gradient <- numeric(k); hessian <- matrix(0, k, k)
  first <- function(g, i, at) (8 * (g(at + unit(i)) - g(at - unit(i))) - (g(at + 2 * unit(i)) - g(at - 2 * unit(i)))) / (12 * h)
  for (i in 1:k) gradient[i] <- first(f, i, x)
  for (i in 1:k) for (j in 1:i) {
    hessian[i, j] <- if (i == j) (16 * (f(x + unit(i)) + f(x - unit(i))) - f(x + 2 * unit(i)) - f(x - 2 * unit(i)) - 30 * f(x)) / (12 * h^2)
                     else first(function(at) first(f, j, at), i, x)
    hessian[j, i] <- hessian[i, j]
  }
  list(gradient = gradient, hessian = hessian)
}
