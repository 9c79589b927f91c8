"""How the messages of a bag are taken in: in full only those that may change something.

Nearly all messages of a mission repeat what the ones before them said. Up to the next thing that falls due, or the next
message that says something new, the last one of each connection stands for all of them; those that somebody wants to
hear one by one are handed to him alone. What follows is the same as if each had been taken in: the tests hold one
against the other.
"""

from __future__ import annotations

import math
from typing import Any, Dict, Iterator, List, Mapping, Set

import numpy as np
from numpy.typing import NDArray

from rqt_mrta_py.app.observation import Observation
from rqt_mrta_py.app.review.habits import Speaker
from rqt_mrta_py.hooks import Heard
from rqt_mrta_py.transport import Block

__all__ = ["Skimming"]

_NS = 1_000_000_000
_NOTHING: Mapping[str, Any] = {}
_new_heard = tuple.__new__
"""Makes a Heard without a call of Python code."""
_GRAIN = 512
"""Receipts as float seconds are this exact, and a little worse [ns]."""
_ENOUGH = 256
"""Where nothing falls due for so many messages, it is not looked whether something has been put off."""


class Skimming:
    """Takes a stream of blocks in, in its order.

    Args:
        observation: takes messages in.
    """

    def __init__(self, observation: Observation) -> None:
        self._observation = observation
        self._supervisor = observation.supervisor
        self._repeats = observation.supervisor.repeats
        self._speakers: List[Speaker] = []
        # By number of the connection.
        self._topics: Dict[str, int] = {}
        self._by_voice: Dict[int, Set[int]] = {}
        self._topic: NDArray[np.int64] = np.empty(0, np.int64)
        self._owners: List[str] = []
        self._at_once: NDArray[np.bool_] = np.empty(0, np.bool_)
        self._each: NDArray[np.bool_] = np.empty(0, np.bool_)
        self._timed: NDArray[np.bool_] = np.empty(0, np.bool_)
        self._ordinals: List[Iterator[int]] = []
        self._says: NDArray[np.bool_] = np.empty(0, np.bool_)
        # At which turn of things a message was last taken in that changed nothing; -1 if the last one did.
        self._settled: NDArray[np.int64] = np.empty(0, np.int64)
        self._unsettled: NDArray[np.bool_] = np.empty(0, np.bool_)
        self._turns = -1
        self._robots = -1
        self._newest = -1

    def feed(self, block: Block) -> None:
        """Take in the next messages of the stream."""
        self._meet(block)
        numbers = block.numbers
        news = self._news(block) | self._at_once[numbers]
        if len(block) and int(block.receipts[0]) < self._newest:
            # Of a bag whose index tells its times wrongly: what comes late counts as received with what came before.
            news[:] = True
        listed, new = numbers.tolist(), news.tolist()
        place, count = 0, len(block)
        while place < count:
            self._settle()
            if new[place] or self._unsettled[listed[place]]:
                self._take(block, place, listed[place])
                place += 1
                continue
            end = self._quiet_end(block, place, news)
            if end > place + 1:
                self._take_together(block, place, end)
                place = end
            else:
                self._take(block, place, listed[place])
                place += 1
        if count:
            self._newest = max(self._newest, int(block.receipts[-1]))

    def _take(self, block: Block, place: int, number: int) -> None:
        """Take in one message in full."""
        repeats = self._repeats
        before = repeats.stirrings
        self._observation.feed(block[place])
        settled = repeats.stirrings == before
        speaker = self._speakers[number]
        if speaker.habit.timed:
            voice = speaker.voice = repeats.voice
            if voice is not None:
                its = self._by_voice.setdefault(id(voice), set())
                its.add(number)
                if not voice.watch.calm:
                    # Whoever is in doubt hears of all that this robot says there.
                    settled = False
                    self._settled[list(its)] = -1
                    self._unsettled[list(its)] = True
        self._settled[number] = repeats.turns if settled else -1
        self._unsettled[number] = not settled

    def _settle(self) -> None:
        """Look whose next message must be taken in, where anything has changed."""
        repeats = self._repeats
        if repeats.turns == self._turns:
            return
        self._turns = repeats.turns
        if repeats.robots != self._robots:
            self._robots = repeats.robots
            self._owners = [repeats.owner(speaker.connection) for speaker in self._speakers]
        stale = self._settled < np.where(self._says, self._turns, 0)
        silent = repeats.silent_robots
        if silent:
            stale |= np.array([owner in silent for owner in self._owners], np.bool_)
        self._unsettled = stale

    def _quiet_end(self, block: Block, place: int, news: NDArray[np.bool_]) -> int:
        """Say up to which message nothing follows from any but the last of each connection."""
        receipts = block.receipts
        enough = int(receipts[min(place + _ENOUGH, len(block) - 1)])
        limit = self._repeats.quiet_until(enough / _NS)
        if limit == -math.inf:
            return place
        end = len(block)
        if limit < math.inf:
            end = int(np.searchsorted(receipts, int(limit * _NS) - _GRAIN, "right"))
        if end <= place:
            return place
        matters = news[place:end] | self._unsettled[block.numbers[place:end]]
        first = int(matters.argmax())
        return place + first if matters[first] else end

    def _take_together(self, block: Block, begin: int, end: int) -> None:
        """Take in messages that say nothing new: the last of each connection in full, others where somebody asks."""
        observation, repeats, supervisor = self._observation, self._repeats, self._supervisor
        numbers = block.numbers[begin:end]
        last = np.zeros(len(self._speakers), np.int64)
        last[numbers] = np.arange(begin, end)
        final = last[numbers] == np.arange(begin, end)
        needed = final | self._each[numbers] | self._timed[numbers]
        passed = np.flatnonzero(~needed)
        skipped: Dict[int, List[int]] = {}
        if len(passed):
            topics = self._topic[numbers]
            for place, topic in zip(passed.tolist(), topics[passed].tolist()):
                skipped.setdefault(topic, []).append(place)
        finals, each, listed = final.tolist(), self._each, numbers.tolist()
        receipts = block.receipts[begin:end].tolist()
        due = supervisor.next_due
        for offset in np.flatnonzero(needed).tolist():
            number = listed[offset]
            if not finals[offset]:
                speaker = self._speakers[number]
                if each[number]:
                    ordinal = observation.glance(block[begin + offset])
                    due = supervisor.next_due
                else:
                    ordinal = next(self._ordinals[number])
                if speaker.voice is None:
                    continue
                topic, receipt = speaker.connection.topic, receipts[offset] / _NS
                if receipt > due:
                    repeats.reach((topic, receipt, ordinal))
                    due = supervisor.next_due
                heard = _new_heard(Heard, (topic, speaker.connection.type, receipt, _NOTHING, "", "", "", ordinal))
                if repeats.hear_again(speaker.voice, heard):
                    due = supervisor.next_due
                continue
            stamped = block[begin + offset]
            if skipped:
                before = skipped.get(int(self._topic[numbers[offset]]))
                if before:
                    count = sum(place < offset for place in before)
                    if count:
                        observation.pass_over(stamped.connection, count)
                        del before[:count]
            observation.feed(stamped)
            due = supervisor.next_due

    def _news(self, block: Block) -> NDArray[np.bool_]:
        """Tell which messages say something else than the one before them on their connection."""
        news = np.zeros(len(block), np.bool_)
        if not len(block):
            return news
        order = np.argsort(block.numbers, kind="stable")
        ordered = block.numbers[order]
        edges = [0, *(np.flatnonzero(np.diff(ordered)) + 1).tolist(), len(order)]
        for first, last in zip(edges[:-1], edges[1:]):
            rows = order[first:last]
            news[rows] = self._speakers[int(ordered[first])].news(block, rows)
        return news

    def _meet(self, block: Block) -> None:
        """Take note of connections that were not known before."""
        fresh = block.connections[len(self._speakers) :]
        if not fresh:
            return
        added = [Speaker(connection, self._observation.habit(connection)) for connection in fresh]
        self._speakers += added
        self._topic = np.append(
            self._topic, [self._topics.setdefault(each.topic, len(self._topics)) for each in fresh]
        ).astype(np.int64)
        self._at_once = np.append(self._at_once, [each.habit.at_once for each in added]).astype(np.bool_)
        self._ordinals += [self._observation.ordinals(each) for each in fresh]
        self._timed = np.append(self._timed, [each.habit.timed for each in added]).astype(np.bool_)
        self._each = np.append(self._each, [each.habit.each for each in added]).astype(np.bool_)
        self._says = np.append(self._says, [each.habit.said is not None for each in added]).astype(np.bool_)
        self._settled = np.append(self._settled, [-1] * len(added)).astype(np.int64)
        self._unsettled = np.append(self._unsettled, [True] * len(added)).astype(np.bool_)
        self._turns = self._robots = -1
