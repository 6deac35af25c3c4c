(* Lemma L1 (cover by cancelling chains) of docs/claim.md, for closed polygons on integer points: tiles whose edges cancel but for the
   walls cover all that the walls wind around. `make prove` has Coq check it. Nothing here is assumed: the last line prints so. *)
From Coq Require Import ZArith List Permutation Lia Psatz.
Import ListNotations.
Open Scope Z_scope.

Definition point := (Z * Z)%type.
Definition edge := (point * point)%type.
Definition minus (a b : point) : point := (fst a - fst b, snd a - snd b).
Definition cross (a b : point) : Z := fst a * snd b - snd a * fst b.
Definition dot (a b : point) : Z := fst a * fst b + snd a * snd b.
Definition turned (e : edge) : edge := (snd e, fst e).

(* How an edge crosses the ray from q to the right: 1 upwards, -1 downwards. As `Region::winding` of the checker. *)
Definition crossing (q : point) (e : edge) : Z :=
  let (a, b) := e in
  let side := cross (minus b a) (minus q a) in
  if snd a <=? snd q
  then (if snd b <=? snd q then 0 else if 0 <? side then 1 else 0)
  else (if snd b <=? snd q then (if side <? 0 then -1 else 0) else 0).

(* The winding number of a set of edges about q. *)
Fixpoint winding (q : point) (edges : list edge) : Z :=
  match edges with [] => 0 | e :: rest => crossing q e + winding q rest end.

(* The edges of a closed walk. *)
Fixpoint path (a : point) (rest : list point) : list edge :=
  match rest with [] => [] | b :: more => (a, b) :: path b more end.
Definition edges_of (tile : list point) : list edge :=
  match tile with [] => [] | a :: rest => path a (rest ++ [a]) end.

(* q is in the hull of the tile: no direction has all corners strictly on its side of q. For integer points this is the convex hull:
   outside of it some rational direction separates, and a multiple of it is whole. *)
Definition in_hull (q : point) (tile : list point) : Prop :=
  forall n : point, exists v, In v tile /\ dot n (minus v q) <= 0.

(* What is left of edges when equal and opposite ones, and those without length, are taken away (`loose_edges`). *)
Inductive cancels : list edge -> list edge -> Prop :=
| nothing : forall l m, Permutation l m -> cancels l m
| pair : forall l e m k, Permutation l (e :: turned e :: m) -> cancels m k -> cancels l k
| point_like : forall l a m k, Permutation l ((a, a) :: m) -> cancels m k -> cancels l k.

Lemma crossing_turned : forall q e, crossing q (turned e) = - crossing q e.
Proof.
  intros [qx qy] [[ax ay] [bx by_]]. unfold turned, crossing, cross, minus. simpl.
  destruct (ay <=? qy), (by_ <=? qy); try reflexivity.
  - replace ((ax - bx) * (qy - by_) - (ay - by_) * (qx - bx))
      with (- ((bx - ax) * (qy - ay) - (by_ - ay) * (qx - ax))) by ring.
    set (s := (bx - ax) * (qy - ay) - (by_ - ay) * (qx - ax)).
    destruct (Z.ltb_spec (- s) 0), (Z.ltb_spec 0 s); lia.
  - replace ((ax - bx) * (qy - by_) - (ay - by_) * (qx - bx))
      with (- ((bx - ax) * (qy - ay) - (by_ - ay) * (qx - ax))) by ring.
    set (s := (bx - ax) * (qy - ay) - (by_ - ay) * (qx - ax)).
    destruct (Z.ltb_spec 0 (- s)), (Z.ltb_spec s 0); lia.
Qed.

Lemma crossing_point : forall q a, crossing q (a, a) = 0.
Proof. intros [qx qy] [ax ay]. unfold crossing. simpl. destruct (ay <=? qy); reflexivity. Qed.

Lemma winding_app : forall q l m, winding q (l ++ m) = winding q l + winding q m.
Proof. induction l; intros; simpl; [lia | rewrite IHl; lia]. Qed.

Lemma winding_permuted : forall q l m, Permutation l m -> winding q l = winding q m.
Proof. induction 1; simpl; lia. Qed.

Lemma winding_cancelled : forall q l m, cancels l m -> winding q l = winding q m.
Proof.
  induction 1 as [l m P | l e m k P _ IH | l a m k P _ IH]; rewrite (winding_permuted _ _ _ P); cbn [winding].
  - reflexivity.
  - rewrite crossing_turned. lia.
  - rewrite crossing_point. lia.
Qed.

(* Whether v is above q: seen from a half plane that the ray to the left stays out of, each edge crosses the ray to the right as
   often as this changes. *)
Definition above (q v : point) : Z := if snd v <=? snd q then 0 else 1.

Lemma crossing_right : forall n q a b, 0 < fst n -> 0 < dot n (minus a q) -> 0 < dot n (minus b q) ->
  crossing q (a, b) = above q b - above q a.
Proof.
  intros [nx ny] [qx qy] [ax ay] [bx by_]. unfold crossing, above, cross, minus, dot. simpl. intros N A B.
  destruct (Z.leb_spec ay qy), (Z.leb_spec by_ qy); try lia.
  - destruct (Z.ltb_spec 0 ((bx - ax) * (qy - ay) - (by_ - ay) * (qx - ax))) as [|S]; [lia | exfalso].
    assert (0 < (nx * (ax - qx) + ny * (ay - qy)) * (by_ - qy)) by (apply Z.mul_pos_pos; lia).
    assert (0 <= (nx * (bx - qx) + ny * (by_ - qy)) * (qy - ay)) by (apply Z.mul_nonneg_nonneg; lia).
    assert (nx * ((bx - ax) * (qy - ay) - (by_ - ay) * (qx - ax)) <= 0) by nia.
    nia.
  - destruct (Z.ltb_spec ((bx - ax) * (qy - ay) - (by_ - ay) * (qx - ax)) 0) as [|S]; [lia | exfalso].
    assert (0 <= (nx * (ax - qx) + ny * (ay - qy)) * (qy - by_)) by (apply Z.mul_nonneg_nonneg; lia).
    assert (0 < (nx * (bx - qx) + ny * (by_ - qy)) * (ay - qy)) by (apply Z.mul_pos_pos; lia).
    assert (0 <= nx * ((bx - ax) * (qy - ay) - (by_ - ay) * (qx - ax))) by nia.
    nia.
Qed.

Lemma crossing_left : forall n q a b, fst n <= 0 -> 0 < dot n (minus a q) -> 0 < dot n (minus b q) ->
  crossing q (a, b) = 0.
Proof.
  intros [nx ny] [qx qy] [ax ay] [bx by_]. unfold crossing, cross, minus, dot. simpl. intros N A B.
  destruct (Z.leb_spec ay qy), (Z.leb_spec by_ qy); try reflexivity.
  - destruct (Z.ltb_spec 0 ((bx - ax) * (qy - ay) - (by_ - ay) * (qx - ax))) as [S|]; [exfalso | reflexivity].
    assert (0 < (nx * (ax - qx) + ny * (ay - qy)) * (by_ - qy)) by (apply Z.mul_pos_pos; lia).
    assert (0 <= (nx * (bx - qx) + ny * (by_ - qy)) * (qy - ay)) by (apply Z.mul_nonneg_nonneg; lia).
    assert (0 <= - nx * ((bx - ax) * (qy - ay) - (by_ - ay) * (qx - ax))) by (apply Z.mul_nonneg_nonneg; lia).
    nia.
  - destruct (Z.ltb_spec ((bx - ax) * (qy - ay) - (by_ - ay) * (qx - ax)) 0) as [S|]; [exfalso | reflexivity].
    assert (0 <= (nx * (ax - qx) + ny * (ay - qy)) * (qy - by_)) by (apply Z.mul_nonneg_nonneg; lia).
    assert (0 < (nx * (bx - qx) + ny * (by_ - qy)) * (ay - qy)) by (apply Z.mul_pos_pos; lia).
    assert (0 <= - nx * - ((bx - ax) * (qy - ay) - (by_ - ay) * (qx - ax))) by (apply Z.mul_nonneg_nonneg; lia).
    nia.
Qed.

Lemma last_of_more : forall (rest : list point) (a b : point), last (b :: rest) a = last rest b.
Proof.
  induction rest as [|c rest IH]; intros a b; [reflexivity|].
  change (last (c :: rest) a = last (c :: rest) b). rewrite !IH. reflexivity.
Qed.

(* A closed walk on one side of a line through q does not wind around q. *)
Lemma path_winding : forall n q rest a, (forall v, In v (a :: rest) -> 0 < dot n (minus v q)) ->
  winding q (path a rest) = if 0 <? fst n then above q (last rest a) - above q a else 0.
Proof.
  intros n q rest. induction rest as [|b rest IH]; intros a H; cbn [path winding].
  - cbn [last]. destruct (0 <? fst n); lia.
  - rewrite IH by (intros; apply H; simpl in *; tauto).
    assert (A : 0 < dot n (minus a q)) by (apply H; simpl; tauto).
    assert (B : 0 < dot n (minus b q)) by (apply H; simpl; tauto).
    rewrite (last_of_more rest a b). destruct (Z.ltb_spec 0 (fst n)).
    + rewrite (crossing_right n) by assumption. lia.
    + rewrite (crossing_left n) by assumption. lia.
Qed.

Lemma apart_no_winding : forall n q tile, (forall v, In v tile -> 0 < dot n (minus v q)) -> winding q (edges_of tile) = 0.
Proof.
  intros n q [|a rest] H; [reflexivity|]. unfold edges_of.
  rewrite (path_winding n).
  - rewrite last_last. destruct (0 <? fst n); lia.
  - intros v I. apply H. simpl in *. rewrite in_app_iff in I. simpl in I. tauto.
Qed.

(* Winding numbers of tiles add up, so that some tile winds around q. *)
Lemma some_tile : forall q tiles, winding q (concat (map edges_of tiles)) <> 0 ->
  exists tile, In tile tiles /\ winding q (edges_of tile) <> 0.
Proof.
  induction tiles as [|tile tiles IH]; simpl; intro H; [lia|]. rewrite winding_app in H.
  destruct (Z.eq_dec (winding q (edges_of tile)) 0).
  - destruct IH as [t [I W]]; [lia|]. eauto.
  - eauto.
Qed.

Definition separates (n q : point) (tile : list point) : Prop := forall v, In v tile -> 0 < dot n (minus v q).

(* L1: what the walls wind around lies in the hull of a tile. *)
Theorem cover : forall (tiles : list (list point)) (walls : list edge) (q : point),
  cancels (concat (map edges_of tiles)) walls -> winding q walls <> 0 ->
  exists tile, In tile tiles /\ in_hull q tile.
Proof.
  intros tiles walls q C W. rewrite <- (winding_cancelled _ _ _ C) in W.
  destruct (some_tile _ _ W) as [tile [I T]]. exists tile. split; [assumption|].
  intro n.
  destruct (Exists_dec (fun v => dot n (minus v q) <= 0) tile (fun v => Z_le_dec (dot n (minus v q)) 0)) as [E|E].
  - apply Exists_exists in E. destruct E as [v [J L]]. eauto.
  - exfalso. apply T. apply (apart_no_winding n). intros v J.
    destruct (Z_le_dec (dot n (minus v q)) 0); [|lia].
    exfalso. apply E. apply Exists_exists. eauto.
Qed.

Print Assumptions cover.
