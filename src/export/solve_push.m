function solve_push()
% Solves the push in this folder the way of Chavan-Dafle and Rodriguez (IROS 2015).
%
%   minimise x' H x / 2 + f' x   subject to   A x <= b,  Aeq x = beq,  lb <= x <= ub
%
% The objective is the sum of all complementarity products. It is never negative where the
% constraints hold, and zero exactly at an answer of the contact problem; the program is not convex,
% so a solver may also stop at a point where it is not zero. Such a point is not an answer.
%
%   octave --path FOLDER --eval solve_push        matlab -batch "addpath FOLDER; solve_push"
%
% GNU Octave >= 7 (glpk), or MATLAB with its Optimization Toolbox (linprog, and fmincon first).
% Each start descends by linear programs along the gradient (Frank and Wolfe): Octave's qp and sqp
% cycle on constraints as degenerate as these. Writes answer.json here, in SI units.
  folder = fileparts(mfilename('fullpath'));
  names = jsondecode(fileread(fullfile(folder, 'names.json')));
  p = struct();
  for name = {'H', 'f', 'A', 'b', 'Aeq', 'beq', 'lb', 'ub', 'answer'}
    p.(name{1}) = read_matrix(fullfile(folder, [name{1} '.mtx']));
  end
  p.lb(p.lb <= -names.no_bound) = -Inf;
  p.ub(p.ub >= names.no_bound) = Inf;
  n = numel(p.f);
  is_contact = strncmp({names.Aeq.symbol}', 'r_', 2);
  p.push = max([0; abs(p.beq(is_contact))]);
  target = fullfile(folder, 'answer.json');
  if exist(target, 'file'), delete(target); end

  if exist('OCTAVE_VERSION', 'builtin'), rand('twister', 1); else, rng(1); end
  fprintf('%s%d unknowns\n', [names.title repmat(': ', 1, ~isempty(names.title))], n);
  best = [];
  for start = 1:12
    cost = double(isfinite(p.lb));
    if start > 1, cost = cost .* (0.1 + 0.9 * rand(n, 1)); end
    [first, outcome] = linear_program(p, cost);
    if strcmp(outcome, 'infeasible')
      fprintf(['No x meets the linear constraints, whatever the products: no forces and motion obey ' ...
               'Newton, the grip forces and the prescribed motions at once.\n']);
      finish(1);
      return
    elseif ~strcmp(outcome, 'optimal')
      fprintf('start %d: no feasible point found\n', start);
      continue
    end
    [x, count] = descend(p, interior_point(p, first));
    fprintf('start %d: objective %.3e -> %.3e, violation %.1e, %d linear programs\n', start, ...
            objective(p, first), objective(p, x), violation(p, x), count);
    if isempty(best) || objective(p, x) < objective(p, best), best = x; end
    if is_answer(p, x), best = x; break, end
  end
  if isempty(best), finish(1); return, end
  write_answer(target, p, names, best);
  if is_answer(p, best)
    fprintf('Objective %.3e: zero to rounding. answer.json holds an answer.\n', objective(p, best));
    finish(0);
  else
    fprintf(['Objective %.3e, violation %.1e; rounding would leave %.1e. This is NOT a solution: ' ...
             'forces and motions in answer.json break the contact laws.\n'], ...
            objective(p, best), violation(p, best), tolerance(p, best));
    finish(1);
  end
end

% The exit status where a script has one; MATLAB's session goes on.
function finish(status)
  if exist('OCTAVE_VERSION', 'builtin') && status ~= 0, exit(status); end
end

function M = read_matrix(path)
  file = fopen(path);
  header = fgetl(file);
  line = fgetl(file);
  while line(1) == '%', line = fgetl(file); end
  sizes = sscanf(line, '%d')';
  if isempty(strfind(header, 'coordinate'))
    M = reshape(fscanf(file, '%f', prod(sizes)), sizes);
  else
    T = fscanf(file, '%f', [3 sizes(3)]);
    M = sparse(T(1, :), T(2, :), T(3, :), sizes(1), sizes(2));
  end
  fclose(file);
end

function y = objective(p, x)
  y = x' * (p.H * x) / 2 + p.f' * x;
end

% The largest violation of any constraint, in the scene's units.
function y = violation(p, x)
  y = full(max([0; p.A * x - p.b; abs(p.Aeq * x - p.beq); p.lb - x]));
end

% What rounding may leave of the objective; and no more than a millionth of the push.
function y = tolerance(p, x)
  y = 1e-12 * (1 + max(abs(x)) ^ 2);
  if p.push > 0, y = min(y, 1e-6 * p.push); end
end

function y = is_answer(p, x)
  y = objective(p, x) <= tolerance(p, x) && violation(p, x) <= 1e-9;
end

function [x, outcome] = linear_program(p, cost)
  outcome = 'unknown';
  if exist('glpk')
    types = [repmat('U', 1, numel(p.b)) repmat('S', 1, numel(p.beq))];
    for presolve = [1 0] % the presolver sometimes finds a feasible problem infeasible
      [x, ~, failed, extra] = glpk(cost, [p.A; p.Aeq], [p.b; p.beq], p.lb, p.ub, types, ...
                                   repmat('C', 1, numel(cost)), 1, ...
                                   struct('msglev', 0, 'presol', presolve));
      if ~failed && extra.status == 5, outcome = 'optimal'; return, end
      if ~failed && any(extra.status == [3 4]), outcome = 'infeasible'; end
    end
  else
    options = optimoptions('linprog', 'Display', 'off', 'ConstraintTolerance', 1e-9, ...
                           'OptimalityTolerance', 1e-10);
    [x, ~, flag] = linprog(cost, p.A, p.b, p.Aeq, p.beq, p.lb, p.ub, options);
    if flag == 1, outcome = 'optimal'; elseif flag == -2, outcome = 'infeasible'; end
  end
end

% MATLAB: the paper's own kind of solver first. Octave: the start itself.
function x = interior_point(p, x)
  if ~exist('fmincon'), return, end
  options = optimoptions('fmincon', 'Algorithm', 'interior-point', 'Display', 'off', ...
                         'SpecifyObjectiveGradient', true, 'HessianFcn', @(x, multipliers) p.H);
  found = fmincon(@(x) deal(objective(p, x), p.H * x + p.f), x, p.A, p.b, p.Aeq, p.beq, p.lb, ...
                  p.ub, [], options);
  if violation(p, found) <= 1e-5, x = found; end
end

function [x, count] = descend(p, x)
  for count = 1:300
    slopes = p.H * x + p.f;
    [vertex, outcome] = linear_program(p, slopes);
    if ~strcmp(outcome, 'optimal'), break, end
    direction = vertex - x;
    slope = slopes' * direction;
    if slope >= -1e-15, break, end
    curvature = direction' * (p.H * direction);
    if curvature > 0, size = min(1, -slope / curvature); else, size = 1; end
    x = x + size * direction;
  end
end

function write_answer(target, p, names, x)
  y = full(p.answer * x);
  contacts = cellstr(names.contacts);
  actuators = numel(cellstr(names.actuators)) * ~isempty(names.actuators);
  status = 'stagnated';
  if is_answer(p, x), status = 'solved'; end
  file = fopen(target, 'w');
  fprintf(file, '{\n  "status": "%s",\n  "solver": "linear programs, solve_push.m",\n', status);
  fprintf(file, '  "objective": %.17g,\n  "violation": %.17g,\n', objective(p, x), violation(p, x));
  fprintf(file, '  "friction": {"law": "pyramids", "facets": %d},\n', names.facets);
  fprintf(file, '  "object": {"acceleration": %s},\n', list(y(1:6)));
  fprintf(file, '  "closing": %s,\n  "contacts": [', list(y(7:6 + actuators)));
  for k = 1:numel(contacts)
    c = y(6 + actuators + 8 * (k - 1) + (1:8));
    if k > 1, fprintf(file, ','); end
    fprintf(file, ['\n    {"name": %s, "normal_force": %.17g, "friction_force": %s, ' ...
                   '"torsion": %.17g, "acceleration": %s}'], ...
            jsonencode(contacts{k}), c(1), list(c(2:4)), c(5), list(c(6:8)));
  end
  fprintf(file, '\n  ]\n}\n');
  fclose(file);
end

function text = list(numbers)
  text = ['[' strjoin(arrayfun(@(x) sprintf('%.17g', x), numbers(:)', 'UniformOutput', false), ', ') ']'];
end
