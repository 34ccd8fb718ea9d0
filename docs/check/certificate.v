(* What docs/check/lcpush_check.py accepts is true: the last stage of the checker, in which a problem
   L, q and the numbers of a certificate are there as fractions and only signs are left to be looked at.
   certificates.md says what is proved here and what is not. To check it, with Coq 8.16:

       coqc docs/check/certificate.v

   Vectors are functions of an index, and a sum runs over a list of indices. *)

Require Import QArith Qminmax Qabs List Lqa.
Import ListNotations.
Open Scope Q_scope.

Definition vector := nat -> Q.
Definition matrix := nat -> nat -> Q.

Fixpoint sum (over : list nat) (f : vector) : Q :=
  match over with
  | [] => 0
  | i :: rest => f i + sum rest f
  end.

Definition dot (over : list nat) (a b : vector) : Q := sum over (fun i => a i * b i).

(* ---- Sums ---- *)

Lemma sum_app (a b : list nat) (f : vector) : sum (a ++ b) f == sum a f + sum b f.
Proof. induction a; simpl; lra. Qed.

Lemma sum_add (l : list nat) (f g : vector) : sum l (fun i => f i + g i) == sum l f + sum l g.
Proof. induction l; simpl; lra. Qed.

Lemma sum_scale (l : list nat) (k : Q) (f : vector) : sum l (fun i => k * f i) == k * sum l f.
Proof. induction l; simpl; lra. Qed.

Lemma sum_zero (l : list nat) : sum l (fun _ => 0) == 0.
Proof. induction l; simpl; lra. Qed.

Lemma sum_equal (l : list nat) (f g : vector) :
  (forall i, In i l -> f i == g i) -> sum l f == sum l g.
Proof.
  induction l as [|i rest IH]; intro same; simpl; [lra|].
  assert (f i == g i) by (apply same; now left).
  assert (sum rest f == sum rest g) by (apply IH; intros; apply same; now right).
  lra.
Qed.

Lemma sum_below (l : list nat) (f g : vector) :
  (forall i, In i l -> f i <= g i) -> sum l f <= sum l g.
Proof.
  induction l as [|i rest IH]; intro below; simpl; [lra|].
  assert (f i <= g i) by (apply below; now left).
  assert (sum rest f <= sum rest g) by (apply IH; intros; apply below; now right).
  lra.
Qed.

Lemma sum_positive (l : list nat) (f : vector) : (forall i, In i l -> 0 <= f i) -> 0 <= sum l f.
Proof. intro positive. rewrite <- (sum_zero l). now apply sum_below. Qed.

(* The rows' weights times what the columns make of them, in either order. *)
Lemma sum_swap (rows columns : list nat) (L : matrix) (x y : vector) :
  sum rows (fun i => y i * sum columns (fun j => L i j * x j)) ==
  sum columns (fun j => x j * sum rows (fun i => L i j * y i)).
Proof.
  induction rows as [|i rest IH]; simpl.
  - rewrite (sum_equal columns _ (fun _ => 0)); [now rewrite sum_zero | intros; lra].
  - rewrite IH. rewrite <- sum_scale, <- sum_add. apply sum_equal. intros. lra.
Qed.

(* ---- "answer": these numbers solve every law of the problem ---- *)

Section Answer.
Variables (all : list nat) (free : nat -> bool) (L : matrix) (q x : vector).

Definition w (i : nat) : Q := sum all (fun j => L i j * x j) + q i.

Definition solves : Prop := forall i, In i all ->
  if free i then w i == 0 else 0 <= x i /\ 0 <= w i /\ x i * w i == 0.

(* As the checker asks: v == 0 if i in free else min(x[i], v) == 0. *)
Definition accepts_answer : bool :=
  forallb (fun i => if free i then Qeq_bool (w i) 0 else Qeq_bool (Qmin (x i) (w i)) 0) all.

Theorem answer_is_true : accepts_answer = true <-> solves.
Proof.
  unfold accepts_answer, solves. rewrite forallb_forall.
  split; intros accepted i present; specialize (accepted i present); destruct (free i).
  - now apply Qeq_bool_iff.
  - apply Qeq_bool_iff in accepted.
    destruct (Q.min_spec (x i) (w i)) as [[order smaller]|[order smaller]];
      rewrite smaller in accepted; repeat split; try lra; rewrite accepted; lra.
  - now apply Qeq_bool_iff.
  - apply Qeq_bool_iff. destruct accepted as [nonnegative [above product]].
    destruct (Qmult_integral _ _ product) as [zero|zero].
    + rewrite zero. apply Q.min_l. assumption.
    + rewrite zero. apply Q.min_r. assumption.
Qed.
End Answer.

(* ---- "no_answer": no z >= 0 makes every w >= 0 (Farkas) ---- *)

Section NoAnswer.
Variables (all : list nat) (free : nat -> bool) (L : matrix) (q y : vector).

Definition gain (j : nat) : Q := sum all (fun i => L i j * y i).

Definition feasible (x : vector) : Prop := forall i, In i all ->
  if free i then w all L q x i == 0 else 0 <= x i /\ 0 <= w all L q x i.

Definition accepts_no_answer : bool :=
  forallb (fun i => free i || Qle_bool 0 (y i)) all && negb (Qle_bool 0 (dot all y q)) &&
  forallb (fun j => Qle_bool (if free j then Qabs (gain j) else gain j) 0) all.

Lemma weights_times_rows (x : vector) :
  dot all y (w all L q x) == dot all x gain + dot all y q.
Proof.
  unfold dot, w, gain.
  rewrite <- (sum_swap all all L x y), <- sum_add. apply sum_equal. intros. lra.
Qed.

Theorem no_answer_is_true : accepts_no_answer = true -> forall x, ~ feasible x.
Proof.
  unfold accepts_no_answer. intros accepted x possible.
  apply andb_prop in accepted as [accepted small]. apply andb_prop in accepted as [signs against].
  rewrite forallb_forall in signs, small. apply Bool.negb_true_iff in against.
  assert (dot all y q < 0) as contradiction.
  { apply Qnot_le_lt. intro wrong. apply Qle_bool_iff in wrong. congruence. }
  assert (0 <= dot all y (w all L q x)) as rows.
  { apply sum_positive. intros i present. specialize (possible i present).
    specialize (signs i present). destruct (free i); simpl in signs.
    - rewrite possible. lra.
    - apply Qle_bool_iff in signs. apply Qmult_le_0_compat; tauto. }
  assert (dot all x gain <= 0) as columns.
  { unfold dot. rewrite <- (sum_zero all). apply sum_below. intros j present.
    specialize (possible j present). specialize (small j present). apply Qle_bool_iff in small.
    destruct (free j).
    - assert (gain j == 0) as none.
      { pose proof (Qabs_nonneg (gain j)). pose proof (Qle_Qabs (gain j)).
        pose proof (Qle_Qabs (- gain j)). rewrite Qabs_opp in H1. lra. }
      rewrite none. lra.
    - destruct possible as [positive _].
      assert (0 <= x j * - gain j) by (apply Qmult_le_0_compat; lra). lra. }
  rewrite weights_times_rows in rows. lra.
Qed.
End NoAnswer.

(* ---- "cannot_hold": no forces inside the friction cones balance the load ---- *)

(* A contact point with friction: its normal forces, its friction forces. *)
Record cone := { mu : Q; normals : list nat; frictions : list nat }.

Section CannotHold.
(* The rows of equality, all cones, and the forces of contacts without friction. *)
Variables (rows : list nat) (cones : list cone) (smooth : list nat).
Variables (L : matrix) (q y : vector).

Definition forces : list nat := flat_map (fun c => normals c ++ frictions c) cones ++ smooth.
Definition taken (j : nat) : Q := sum rows (fun i => L i j * y i).

(* Every row balances, no force is negative, and friction stays within its cone. *)
Definition balances (f : vector) : Prop :=
  (forall i, In i rows -> sum forces (fun j => L i j * f j) + q i == 0) /\
  (forall j, In j forces -> 0 <= f j) /\
  (forall c, In c cones -> sum (frictions c) f <= mu c * sum (normals c) f).

Definition accepts_cannot_hold : bool :=
  negb (Qle_bool 0 (dot rows y q)) &&
  forallb (fun c => forallb (fun i => forallb (fun j =>
    Qle_bool (taken i + mu c * taken j) 0) (frictions c)) (normals c)) cones &&
  forallb (fun j => Qle_bool (taken j) 0) smooth.

(* Friction can act in every direction, so one of its generators gains or takes nothing. *)
Hypothesis all_around : forall c, In c cones -> exists j, In j (frictions c) /\ 0 <= taken j.

(* The friction direction that gains most. *)
Lemma most (l : list nat) : l <> [] -> exists best, In best l /\ forall j, In j l -> taken j <= taken best.
Proof.
  induction l as [|i rest IH]; [congruence|]. intros _.
  destruct rest as [|k rest'].
  - exists i. split; [now left|]. intros j [same|none]; [subst; lra | destruct none].
  - destruct IH as [best [present largest]]; [congruence|].
    destruct (Qlt_le_dec (taken best) (taken i)) as [less|more].
    + exists i. split; [now left|]. intros j [same|other]; [subst; lra|].
      specialize (largest j other). lra.
    + exists best. split; [now right|]. intros j [same|other]; [subst; lra | now apply largest].
Qed.

Lemma cone_takes (c : cone) (f : vector) :
  In c cones ->
  (forall j, In j (normals c ++ frictions c) -> 0 <= f j) ->
  sum (frictions c) f <= mu c * sum (normals c) f ->
  (forall i j, In i (normals c) -> In j (frictions c) -> taken i + mu c * taken j <= 0) ->
  sum (normals c ++ frictions c) (fun j => f j * taken j) <= 0.
Proof.
  intros there positive inside edges.
  destruct (all_around c there) as [some [of_some gains]].
  destruct (most (frictions c)) as [best [of_best largest]].
  { intro none. rewrite none in of_some. destruct of_some. }
  assert (0 <= taken best) as best_gains by (specialize (largest some of_some); lra).
  rewrite sum_app.
  assert (sum (frictions c) (fun j => f j * taken j) <= taken best * sum (frictions c) f) as first.
  { rewrite <- sum_scale. apply sum_below. intros j present.
    assert (0 <= f j) by (apply positive; apply in_or_app; now right).
    specialize (largest j present).
    assert (0 <= f j * (taken best - taken j)) by (apply Qmult_le_0_compat; lra). lra. }
  assert (taken best * sum (frictions c) f <= taken best * (mu c * sum (normals c) f)) as second.
  { assert (0 <= taken best * (mu c * sum (normals c) f - sum (frictions c) f))
      by (apply Qmult_le_0_compat; lra). lra. }
  assert (sum (normals c) (fun i => f i * taken i) + taken best * (mu c * sum (normals c) f) <= 0) as third.
  { assert (sum (normals c) (fun i => f i * taken i) + taken best * (mu c * sum (normals c) f) ==
            sum (normals c) (fun i => f i * (taken i + mu c * taken best))) as together.
    { rewrite (sum_equal (normals c) (fun i => f i * (taken i + mu c * taken best))
        (fun i => f i * taken i + (mu c * taken best) * f i)) by (intros; lra).
      rewrite sum_add, sum_scale. lra. }
    rewrite together, <- (sum_zero (normals c)). apply sum_below. intros i present.
    assert (0 <= f i) by (apply positive; apply in_or_app; now left).
    specialize (edges i best present of_best).
    assert (0 <= f i * - (taken i + mu c * taken best)) by (apply Qmult_le_0_compat; lra). lra. }
  lra.
Qed.

Theorem cannot_hold_is_true : accepts_cannot_hold = true -> forall f, ~ balances f.
Proof.
  unfold accepts_cannot_hold. intros accepted f [balance [positive inside]].
  apply andb_prop in accepted as [accepted slick]. apply andb_prop in accepted as [against edges].
  apply Bool.negb_true_iff in against. rewrite forallb_forall in edges, slick.
  assert (dot rows y q < 0) as load.
  { apply Qnot_le_lt. intro wrong. apply Qle_bool_iff in wrong. congruence. }
  assert (sum forces (fun j => f j * taken j) + dot rows y q == 0) as work.
  { unfold taken, dot. rewrite <- (sum_swap rows forces L f y), <- sum_add.
    rewrite <- (sum_zero rows). apply sum_equal. intros i present.
    specialize (balance i present).
    assert (sum forces (fun j => L i j * f j) == - q i) as row by lra. rewrite row. lra. }
  assert (sum forces (fun j => f j * taken j) <= 0) as taking.
  { unfold forces in *. rewrite sum_app.
    assert (sum smooth (fun j => f j * taken j) <= 0) as none.
    { rewrite <- (sum_zero smooth). apply sum_below. intros j present.
      specialize (slick j present). apply Qle_bool_iff in slick.
      assert (0 <= f j) by (apply positive; apply in_or_app; now right).
      assert (0 <= f j * - taken j) by (apply Qmult_le_0_compat; lra). lra. }
    assert (forall some, incl some cones ->
      sum (flat_map (fun c => normals c ++ frictions c) some) (fun j => f j * taken j) <= 0) as each.
    { induction some as [|c rest IH]; intro part; simpl; [lra|]. rewrite sum_app.
      assert (In c cones) as there by (apply part; now left).
      assert (sum (normals c ++ frictions c) (fun j => f j * taken j) <= 0).
      { apply cone_takes; auto.
        - intros j present. apply positive. apply in_or_app. left. apply in_flat_map. now exists c.
        - intros i j of_normals of_frictions. specialize (edges c there).
          rewrite forallb_forall in edges. specialize (edges i of_normals).
          rewrite forallb_forall in edges. specialize (edges j of_frictions).
          now apply Qle_bool_iff. }
      assert (sum (flat_map (fun c => normals c ++ frictions c) rest) (fun j => f j * taken j) <= 0)
        by (apply IH; intros other present; apply part; now right).
      lra. }
    specialize (each cones (fun c present => present)). lra. }
  lra.
Qed.
End CannotHold.

(* No axiom is used: "Closed under the global context". *)
Print Assumptions answer_is_true.
Print Assumptions no_answer_is_true.
Print Assumptions cannot_hold_is_true.
