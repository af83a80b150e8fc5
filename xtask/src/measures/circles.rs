//! Circles in a directed graph: its strongly connected components.

use std::collections::BTreeSet;

/// The sets of nodes that all reach each other, largest first, each sorted; single nodes are left out. `edges[a]` holds
/// the nodes that `a` has an edge to. Costs O(nodes + edges) (R. Tarjan, "Depth-first search and linear graph
/// algorithms", 1972).
pub fn circles(edges: &[BTreeSet<usize>]) -> Vec<Vec<usize>> {
    let mut search =
        Search { edges, found: vec![None; edges.len()], open: Vec::new(), count: 0, circles: Vec::new() };
    for node in 0..edges.len() {
        if search.found.get(node) == Some(&None) {
            search.visit(node);
        }
    }
    let mut circles = search.circles;
    circles.retain(|circle| circle.len() > 1);
    circles.iter_mut().for_each(|circle| circle.sort_unstable());
    circles.sort_by(|a, b| b.len().cmp(&a.len()).then(a.cmp(b)));
    circles
}

struct Search<'a> {
    edges: &'a [BTreeSet<usize>],
    /// When each node was found; `usize::MAX` once its circle is known.
    found: Vec<Option<usize>>,
    /// Nodes whose circle isn't known yet, in the order in which they were found.
    open: Vec<usize>,
    count: usize,
    circles: Vec<Vec<usize>>,
}

impl Search<'_> {
    /// Gives the earliest open node that can be reached.
    fn visit(&mut self, node: usize) -> usize {
        let own = self.count;
        self.count += 1;
        self.mark(node, own);
        let place = self.open.len();
        self.open.push(node);
        let mut earliest = own;
        for &next in self.edges.get(node).into_iter().flatten() {
            earliest = earliest.min(match self.found.get(next).copied().flatten() {
                Some(found) => found,
                None => self.visit(next),
            });
        }
        if earliest < own {
            return earliest;
        }
        let circle = self.open.split_off(place);
        for &node in &circle {
            self.mark(node, usize::MAX);
        }
        self.circles.push(circle);
        // Nothing that is still open can be reached from here.
        usize::MAX
    }

    fn mark(&mut self, node: usize, found: usize) {
        if let Some(slot) = self.found.get_mut(node) {
            *slot = Some(found);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn graph(nodes: usize, edges: &[(usize, usize)]) -> Vec<BTreeSet<usize>> {
        let mut graph = vec![BTreeSet::new(); nodes];
        for &(from, to) in edges {
            graph[from].insert(to);
        }
        graph
    }

    /// The same by definition: nodes that reach each other.
    fn by_definition(edges: &[BTreeSet<usize>]) -> Vec<Vec<usize>> {
        let reach = |start: usize| {
            let mut seen = BTreeSet::from([start]);
            let mut next = vec![start];
            while let Some(node) = next.pop() {
                next.extend(edges[node].iter().copied().filter(|&to| seen.insert(to)));
            }
            seen
        };
        let reached: Vec<_> = (0..edges.len()).map(reach).collect();
        let circle =
            |a: usize| reached[a].iter().copied().filter(|&b| reached[b].contains(&a)).collect::<Vec<_>>();
        let mut circles: Vec<_> = (0..edges.len()).map(circle).filter(|circle| circle.len() > 1).collect();
        circles.sort_by(|a, b| b.len().cmp(&a.len()).then(a.cmp(b)));
        circles.dedup();
        circles
    }

    #[test]
    fn a_tree_and_a_diamond_have_none() {
        assert!(circles(&graph(4, &[(0, 1), (0, 2), (1, 3), (2, 3)])).is_empty());
        assert!(circles(&graph(2, &[(0, 0), (0, 1)])).is_empty(), "a file that names itself is no circle");
    }

    #[test]
    fn circles_that_touch_are_one_and_others_stay_apart() {
        let edges = graph(8, &[(0, 1), (1, 2), (2, 0), (2, 3), (3, 2), (3, 4), (5, 6), (6, 5), (4, 5)]);
        assert_eq!(circles(&edges), [vec![0, 1, 2, 3], vec![5, 6]]);
    }

    #[test]
    fn random_graphs_agree_with_the_definition() {
        let mut state = 1_u64;
        let mut random = |below: usize| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 33) as usize % below
        };
        for _ in 0..300 {
            let nodes = 1 + random(12);
            let edges: Vec<_> = (0..random(3 * nodes)).map(|_| (random(nodes), random(nodes))).collect();
            let edges = graph(nodes, &edges);
            assert_eq!(circles(&edges), by_definition(&edges), "{edges:?}");
        }
    }
}
