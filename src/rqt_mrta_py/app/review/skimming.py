"""How the messages of a bag are taken in: in full only those that may change something.

Nearly all messages of a mission repeat what the ones before them said. What such a one does is known: it shows a robot,
and puts off what falls due. So up to the next message that says something new, or that something falls due in spite of
all that was said, only the last one of each connection is followed, and an interpreter hears it; those that somebody
wants to hear one by one are handed to him alone. What comes of it is the same as if each had been taken in: the tests
hold one against the other.
"""

from __future__ import annotations

import math
from bisect import bisect_left, bisect_right
from typing import Dict, List, Optional, Set

import numpy as np
from numpy.typing import NDArray

from rqt_mrta_py.app.observation import Observation
from rqt_mrta_py.app.review.beats import Beats
from rqt_mrta_py.app.review.habits import Speaker
from rqt_mrta_py.app.review.outlook import Outlook
from rqt_mrta_py.supervisor.echo import Name
from rqt_mrta_py.transport import Block, ConnectionList

__all__ = ["Skimming"]

_NS = 1_000_000_000
_GRAIN = 512
"""Receipts as float seconds are this exact, and a little worse [ns]."""
_WINDOW = 512
"""So many messages are looked at together for the next one that matters."""


class Skimming:
    """Takes a stream of blocks in, in its order.

    Args:
        observation: takes messages in.
    """

    def __init__(self, observation: Observation) -> None:
        self._observation = observation
        self._supervisor = observation.supervisor
        self._repeats = observation.supervisor.repeats
        self._glance_at = observation.glance
        self._speakers: List[Speaker] = []
        # Messages by topic: those met, and those that the observation has counted.
        self._met: Dict[str, int] = {}
        self._counted: Dict[str, int] = {}
        # By number of the connection.
        self._each: NDArray[np.bool_] = np.empty(0, np.bool_)
        self._unsettled: NDArray[np.bool_] = np.empty(0, np.bool_)
        # Who has anything to do with a robot that is waited for; None if there is no such robot.
        self._awaited: Optional[NDArray[np.bool_]] = None
        # Of which connections the newest message speaks of something.
        self._speaking: Dict[Name, Set[int]] = {}
        self._by_voice: Dict[int, Set[int]] = {}
        self._newest = -1
        # Of the block: up to where messages have been taken in, been followed, and been told again.
        self._place = self._followed = self._told = 0
        self._beats: Optional[Beats] = None
        self._limit: Optional[float] = None
        self._begin(Outlook(Block.of(ConnectionList(), ()), (), {}))

    def feed(self, block: Block) -> None:
        """Take in the next messages of the stream."""
        self.look(block)
        self.advance(len(block))

    def look(self, block: Block) -> None:
        """Look at the next messages of the stream, to be taken in by ``advance``; all before have been."""
        self._meet(block)
        outlook = Outlook(block, self._speakers, self._met)
        if len(block):
            if outlook.receipts[0] < self._newest:
                # Of a bag whose index tells its times wrongly: what comes late counts as received with the one before.
                outlook.news[:] = True
            self._newest = max(self._newest, outlook.receipts[-1])
        self._begin(outlook)

    def advance(self, upto: int) -> None:
        """Take in the messages of the block up to a place."""
        place = self._place
        if place >= upto:
            return
        while place < upto:
            self._settle()
            if self._beats is None:
                self._beats = Beats(self._outlook, place)
            end = self._quiet_end(place, upto)
            if end > place:
                place = self._glance(place, end)
            else:
                self._catch_up(place)
                self._take(place)
                place += 1
        self._catch_up(place)
        self._repeats.reach(self._outlook.key(place - 1))
        self._place = place

    def _begin(self, outlook: Outlook) -> None:
        self._outlook = outlook
        self._place = self._followed = self._told = 0
        self._beats = self._limit = None
        numbers = outlook.block.numbers
        self._glances: List[int] = np.flatnonzero(self._each[numbers]).tolist() if self._each.any() else []

    def _take(self, place: int) -> None:
        """Take in one message in full."""
        outlook, repeats = self._outlook, self._repeats
        number = outlook.numbers[place]
        speaker = self._speakers[number]
        topic, ordinal = speaker.connection.topic, outlook.ordinals[place]
        missing = ordinal - self._counted.get(topic, 0)
        if missing:
            self._observation.pass_over(speaker.connection, missing)
        self._counted[topic] = ordinal + 1
        before = repeats.stirrings
        echo = repeats.listen()
        self._observation.feed(outlook.block[place])
        settled = repeats.stirrings == before
        if speaker.habit.timed:
            settled = self._hold_to_voice(number, speaker) and settled
        self._unsettled[number] = not settled
        if speaker.echo is None or speaker.echo.names != echo.names:
            for name in () if speaker.echo is None else speaker.echo.names:
                self._speaking[name].discard(number)
            for name in echo.names:
                self._speaking.setdefault(name, set()).add(number)
        speaker.take(echo)
        self._followed = self._told = place + 1
        self._limit = None
        if self._beats is not None:
            self._beats.skip(place + 1)

    def _hold_to_voice(self, number: int, speaker: Speaker) -> bool:
        """Take note whose message came; tell whether nothing is in doubt of how that robot speaks."""
        voice = self._repeats.voice
        if voice is not speaker.voice:
            speaker.voice, self._beats = voice, None
        if voice is None:
            return True
        its = self._by_voice.setdefault(id(voice), set())
        its.add(number)
        if not voice.watch.calm:
            # Whoever is in doubt hears of all that this robot says there.
            self._unsettled[list(its)] = True
        return voice.is_steady

    def _settle(self) -> None:
        """Look whose next message must be taken in, where anything has changed."""
        turned = self._repeats.turned()
        if turned is None:
            for speaker in self._speakers:
                speaker.owner = self._repeats.owner(speaker.connection)
            self._unsettled[:] = True
        elif turned:
            for name in turned:
                self._unsettled[list(self._speaking.get(name, ()))] = True
        else:
            return
        awaited = self._repeats.awaited
        self._awaited = None
        if awaited:
            owners = [speaker.owner is not None and speaker.owner.id in awaited for speaker in self._speakers]
            self._awaited = np.array(owners, np.bool_)
            for robot in awaited:
                self._awaited[list(self._speaking.get((robot, ""), ()))] = True

    def _quiet_end(self, place: int, upto: int) -> int:
        """Say up to which message nothing follows from any but the last of each connection."""
        outlook = self._outlook
        if outlook.news[place] or self._unsettled[outlook.numbers[place]]:
            return place
        if self._limit is None:
            self._limit = self._repeats.quiet_until
        if self._is_due(place):
            self._put_off(place)
            self._limit = self._repeats.quiet_until
            if self._is_due(place):
                self._let_pass(place)
                if self._matters(place, place + 1)[0] or self._is_due(place):
                    return place
        end = min(upto, place + _WINDOW)
        if self._limit < math.inf:
            end = bisect_right(outlook.receipts, int(self._limit * _NS) - _GRAIN, place, end)
        matters = self._matters(place, end)
        first = int(matters.argmax())
        return place + first if matters[first] else end

    def _matters(self, place: int, end: int) -> NDArray[np.bool_]:
        """Tell which messages between two places must be taken in in full."""
        numbers = self._outlook.block.numbers[place:end]
        matters = self._outlook.news[place:end] | self._unsettled[numbers]
        return matters if self._awaited is None else matters | self._awaited[numbers]

    def _is_due(self, place: int) -> bool:
        """Tell whether something may fall due before a message."""
        limit = self._limit
        return limit is not None and limit < math.inf and not self._outlook.receipts[place] <= limit * _NS - _GRAIN

    def _glance(self, place: int, end: int) -> int:
        """Hand messages between two places to those who want to hear each; answer up to where nothing falls due."""
        glances, outlook = self._glances, self._outlook
        if not glances:
            return end
        glance, numbers, receipts, ordinals = self._glance_at, outlook.numbers, outlook.receipts, outlook.ordinals
        content, begins, ends = outlook.block.content, outlook.begins, outlook.ends
        for each in glances[bisect_left(glances, place) : bisect_left(glances, end)]:
            speaker = self._speakers[numbers[each]]
            raw = content[begins[each] : ends[each]]
            glance(speaker.connection, receipts[each] / _NS, ordinals[each], raw)
            if speaker.habit.wakes and self._limit is not None and self._supervisor.next_due < self._limit:
                self._limit = None
                return each + 1
        return end

    def _put_off(self, place: int) -> None:
        """Let messages up to a place put off what falls due, and look when that is."""
        self._follow(place)
        self._repeats.look_again()

    def _let_pass(self, place: int) -> None:
        """Let happen what falls due before a message."""
        self._catch_up(place)
        self._repeats.reach(self._outlook.key(place))
        self._settle()
        self._limit = self._repeats.quiet_until

    def _catch_up(self, place: int) -> None:
        """Take in the messages up to a place, from which nothing follows but from the last of each connection."""
        self._follow(place)
        outlook = self._outlook
        for each in outlook.last_again(self._told, place):
            for heard in self._speakers[outlook.numbers[each]].again(outlook.block, each, outlook.key(each)):
                self._repeats.tell_again(heard)
        self._told = place

    def _follow(self, end: int) -> None:
        """Do what messages up to a place do that say what the ones before them said."""
        begin = self._followed
        if begin == end:
            return
        if self._beats is not None:
            self._unsettled[self._beats.until(end)] = True
        outlook, speakers, follow = self._outlook, self._speakers, self._repeats.follow
        for place in outlook.last_ones(begin, end):
            speaker, key = speakers[outlook.numbers[place]], outlook.key(place)
            owner = speaker.owner
            if owner is not None:
                owner.heard_at, owner.last_message = key[1], key
            if speaker.echo is not None:
                follow(speaker.echo, key)
        self._followed = end

    def _meet(self, block: Block) -> None:
        """Take note of connections that were not known before."""
        fresh = block.connections[len(self._speakers) :]
        if not fresh:
            return
        added = [Speaker(connection, self._observation.habit(connection)) for connection in fresh]
        for speaker in added:
            speaker.owner = self._repeats.owner(speaker.connection)
        self._speakers += added
        self._each = np.append(self._each, [each.habit.each for each in added]).astype(np.bool_)
        self._unsettled = np.append(self._unsettled, [True] * len(added)).astype(np.bool_)
        if self._awaited is not None:
            self._awaited = np.append(self._awaited, [True] * len(added)).astype(np.bool_)
