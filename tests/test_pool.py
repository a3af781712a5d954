"""The pool keeps few worlds, never one in use, and gives up those nobody uses."""

import threading
import time

from reibench import pool as pools
from reibench.pool import Pool


def test_the_longest_idle_one_leaves_first_and_one_in_use_never(monkeypatch):
    monkeypatch.setattr(pools, "JUST_LENT", 0.0)
    returned = []
    pool = Pool(2, returned.append)
    for owner in ("ann", "ben"):
        pool.lend(owner, owner.upper)
    with pool.lend("ann", str).lock:
        pool.lend("eve", "eve".upper)
        assert returned == ["BEN"]
        pool.lend("ben", "ben".upper)
    assert returned == ["BEN", "EVE"]
    assert len(pool) == 2


def test_what_was_just_lent_stays_until_its_user_has_locked_it():
    returned = []
    pool = Pool(1, returned.append)
    pool.lend("ann", str)
    pool.lend("ben", str)
    assert returned == []


def test_what_nobody_uses_is_given_up():
    returned = []
    pool = Pool(5, returned.append, idle=0.2)
    lease = pool.lend("ann", "ann".upper)
    pool.lend("ben", "ben".upper)
    with lease.lock:
        time.sleep(0.6)
        assert returned == ["BEN"]
    time.sleep(0.4)
    assert returned == ["BEN", "ANN"]
    assert len(pool) == 0


def test_one_that_takes_long_to_make_keeps_no_other_waiting():
    pool = Pool(5, lambda value: None)
    making = threading.Event()
    slow = threading.Thread(target=pool.lend, args=("ann", making.wait))
    slow.start()
    owners = [f"visitor {number}" for number in range(3)]
    others = [owner for owner in owners if hash(owner) % 16 != hash("ann") % 16]
    for owner in others:
        assert pool.lend(owner, owner.upper).value == owner.upper()
    making.set()
    slow.join()
    assert pool.lend("ann", str).value is True


def test_an_owner_gets_one_however_often_it_asks_at_once():
    made = []

    def make():
        time.sleep(0.05)
        made.append(1)
        return len(made)

    pool = Pool(5, lambda value: None)
    threads = [threading.Thread(target=pool.lend, args=("ann", make)) for _ in range(5)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert made == [1]


def test_a_look_at_what_somebody_has_lends_nothing():
    pool = Pool(1, lambda value: None)
    assert pool.peek("ann") is None
    pool.lend("ann", "ann".upper)
    assert pool.peek("ann") == "ANN"
    pool.lend("ben", "ben".upper)
    assert pool.peek("nobody") is None
    assert len(pool) <= 2
