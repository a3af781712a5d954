; What a one-handed household robot can do, in the terms of its skills: every action is one skill.
;
; Objects stand for types: `apple` is whatever apple the robot finds, and `drawer` any drawer.
; Where things are need not be known, because finding a thing takes the robot to it; what has to
; be known is whether it is shut in, and that a problem says with (shut-in thing container).

(define (domain household)
  (:requirements :strips :negative-preconditions :disjunctive-preconditions
                 :existential-preconditions :universal-preconditions :conditional-effects :equality)

  (:predicates
    ; what never changes
    (portable ?x)             ; can be picked up
    (openable ?x)             ; can be opened and closed
    (container ?x)            ; hides what it holds while closed, and takes nothing in then
    (switchable ?x)           ; can be turned on and off
    (lamp ?x)
    (sliceable ?x)
    (cuts ?x)                 ; things are sliced with it
    (fits ?x ?place)          ; x may be put in or on place
    (several ?x)              ; there are more than one: the next one found may be another
    (heats ?x)                ; makes hot what is in it when it is turned on
    (cools ?x)                ; makes cold what is in it when it is closed
    (washes ?x ?basin)        ; makes clean what is in basin when it is turned on
    ; what changes
    (at ?x)                   ; the robot has gone to x
    (hand-empty)
    (holding ?x)
    (shut-in ?x ?container)
    (opened ?x)
    (switched-on ?x)
    ; what goals are made of, beside (holding ?x)
    (in ?x ?place)            ; x is in or on place
    (hot ?x)
    (cold ?x)
    (clean ?x)
    (sliced ?x)
    (lit ?x ?lamp))           ; the robot holds x in the light of lamp

  (:action find
    :parameters (?x)
    :precondition (not (holding ?x))
    :effect (and
      (at ?x)
      (forall (?y) (when (not (= ?y ?x)) (not (at ?y))))
      ; of several drawers, the one that was opened is not known to be the next one found
      (forall (?y) (when (several ?y) (not (opened ?y))))
      (forall (?y ?z) (not (lit ?y ?z)))
      (forall (?y) (when (and (lamp ?x) (switched-on ?x) (holding ?y)) (lit ?y ?x)))))

  (:action pick-up
    :parameters (?x)
    :precondition (and
      (portable ?x)
      (hand-empty)
      (or (at ?x) (exists (?place) (and (at ?place) (in ?x ?place))))
      (forall (?y) (not (shut-in ?x ?y)))
      ; nothing is taken out of running water
      (not (exists (?y ?basin) (and (in ?x ?basin) (washes ?y ?basin) (switched-on ?y)))))
    :effect (and
      (holding ?x)
      (not (hand-empty))
      (forall (?place) (not (in ?x ?place)))))

  (:action put-down
    :parameters (?x ?place)
    :precondition (and
      (holding ?x)
      (at ?place)
      (fits ?x ?place)
      (or (not (container ?place)) (opened ?place)))
    :effect (and
      (in ?x ?place)
      (hand-empty)
      (not (holding ?x))
      (forall (?y) (not (lit ?x ?y)))))

  (:action open
    :parameters (?x)
    :precondition (and
      (openable ?x)
      (not (opened ?x))
      (or (at ?x) (exists (?y) (and (at ?y) (shut-in ?y ?x))))
      (not (and (heats ?x) (switched-on ?x))))
    :effect (and
      (opened ?x)
      (forall (?y) (when (or (at ?y) (not (several ?x))) (not (shut-in ?y ?x))))))

  (:action close
    :parameters (?x)
    :precondition (and
      (openable ?x)
      (opened ?x)
      (or (at ?x) (exists (?y) (and (at ?y) (in ?y ?x)))))
    :effect (and
      (not (opened ?x))
      (forall (?y) (when (and (container ?x) (in ?y ?x)) (shut-in ?y ?x)))
      (forall (?y) (when (and (cools ?x) (in ?y ?x)) (cold ?y)))))

  (:action turn-on
    :parameters (?x)
    :precondition (and
      (switchable ?x)
      (not (switched-on ?x))
      (or (at ?x) (exists (?basin) (and (at ?basin) (washes ?x ?basin))))
      (not (and (heats ?x) (opened ?x))))
    :effect (and
      (switched-on ?x)
      (forall (?y) (when (and (heats ?x) (in ?y ?x)) (hot ?y)))
      (forall (?y ?basin) (when (and (washes ?x ?basin) (in ?y ?basin)) (clean ?y)))
      (forall (?y) (when (and (lamp ?x) (holding ?y)) (lit ?y ?x)))))

  (:action turn-off
    :parameters (?x)
    :precondition (and
      (switchable ?x)
      (switched-on ?x)
      (or (at ?x) (exists (?basin) (and (at ?basin) (washes ?x ?basin)))))
    :effect (and
      (not (switched-on ?x))
      (forall (?y) (not (lit ?y ?x)))))

  (:action slice
    :parameters (?x)
    :precondition (and
      (sliceable ?x)
      (not (sliced ?x))
      (at ?x)
      (exists (?y) (and (cuts ?y) (holding ?y)))
      (forall (?y) (not (shut-in ?x ?y))))
    :effect (and
      (sliced ?x)
      ; the slices are new things: treat them after they are cut
      (not (hot ?x))
      (not (cold ?x))
      (not (clean ?x))))
)
