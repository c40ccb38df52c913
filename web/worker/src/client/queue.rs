//! Queue of questions to a worker.

use std::collections::VecDeque;

/// Question with its asker and the destination of its answer.
pub struct Waiting<Q, A, R> {
    /// Question.
    pub ask: Q,
    /// Asker that needs only the newest answer; `None` for a question that needs its own answer.
    pub asker: Option<A>,
    /// Destination of the answer.
    pub answer: R,
}

/// Waiting questions; the first may be active.
pub struct Queue<Q, A, R>(VecDeque<Waiting<Q, A, R>>);

impl<Q, A, R> Default for Queue<Q, A, R> {
    fn default() -> Queue<Q, A, R> {
        Queue(VecDeque::new())
    }
}

impl<Q, A: PartialEq, R> Queue<Q, A, R> {
    /// Adds a question and removes waiting ones of the same asker; returns the destinations of the removed ones.
    pub fn push(&mut self, question: Waiting<Q, A, R>, first_is_under_way: bool) -> Vec<R> {
        let mut dropped = Vec::new();
        let mut kept = VecDeque::new();
        for (place, older) in self.0.drain(..).enumerate() {
            let under_way = first_is_under_way && place == 0;
            if under_way || older.asker.is_none() || older.asker != question.asker {
                kept.push_back(older);
            } else {
                dropped.push(older.answer);
            }
        }
        kept.push_back(question);
        self.0 = kept;
        dropped
    }

    /// Whether the asker of the first question has a newer question.
    pub fn first_is_outdated(&self) -> bool {
        let mut questions = self.0.iter();
        let first = questions.next().and_then(|first| first.asker.as_ref());
        first.is_some_and(|first| questions.any(|newer| newer.asker.as_ref() == Some(first)))
    }

    /// Destination of the answer to the first question.
    pub fn destination(&self) -> Option<&R> {
        self.0.front().map(|first| &first.answer)
    }

    /// First question.
    pub fn first(&self) -> Option<&Q> {
        self.0.front().map(|first| &first.ask)
    }

    /// Removes the first question and returns the destination of its answer.
    pub fn pop(&mut self) -> Option<R> {
        self.0.pop_front().map(|first| first.answer)
    }

    /// Whether the queue is empty.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn push(queue: &mut Queue<u32, char, u32>, asker: Option<char>, ask: u32) -> Vec<u32> {
        let answer = ask;
        queue.push(Waiting { ask, asker, answer }, true)
    }

    fn rest(queue: &mut Queue<u32, char, u32>) -> Vec<u32> {
        std::iter::from_fn(|| queue.pop()).collect()
    }

    #[test]
    fn the_newest_question_of_an_asker_wins_and_those_of_others_stay() {
        let mut queue = Queue::default();
        for (asker, ask) in [(Some('a'), 1), (Some('a'), 2), (Some('b'), 3), (None, 4)] {
            assert_eq!(push(&mut queue, asker, ask), [0; 0]);
        }
        // the active question continues, and is outdated
        assert!(queue.first_is_outdated());
        assert_eq!(push(&mut queue, Some('a'), 5), [2]);
        assert_eq!(push(&mut queue, None, 6), [0; 0]);
        assert_eq!(push(&mut queue, Some('b'), 7), [3]);
        assert_eq!(rest(&mut queue), [1, 4, 5, 6, 7]);
    }

    #[test]
    fn a_question_is_not_outdated_by_another_asker_or_by_questions_of_nobody() {
        let mut queue = Queue::default();
        push(&mut queue, Some('a'), 1);
        push(&mut queue, Some('b'), 2);
        assert!(!queue.first_is_outdated());
        let mut of_nobody = Queue::default();
        push(&mut of_nobody, None, 1);
        push(&mut of_nobody, None, 2);
        assert!(!of_nobody.first_is_outdated());
        assert_eq!(rest(&mut of_nobody), [1, 2]);
    }

    #[test]
    fn before_the_first_is_sent_it_may_be_dropped_too() {
        let mut queue: Queue<u32, char, u32> = Queue::default();
        let question = |ask| Waiting {
            ask,
            asker: Some('a'),
            answer: ask,
        };
        assert_eq!(queue.push(question(1), false), [0; 0]);
        assert_eq!(queue.push(question(2), false), [1]);
        assert_eq!(queue.first(), Some(&2));
        assert_eq!(rest(&mut queue), [2]);
    }
}
