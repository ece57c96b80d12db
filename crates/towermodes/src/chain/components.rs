//! Code that is written once and repeated for each component of a motion.

/// Repeats a block for each of the components 0 to D − 1, D ≤ 6, with the component as a constant:
/// in a loop the entries of small matrices are not kept in registers.
macro_rules! for_components {
    ($dimension:ident, $component:ident, $block:block) => {
        for_components!(@each $dimension, $component, $block, 0, 1, 2, 3, 4, 5)
    };
    (@each $dimension:ident, $component:ident, $block:block, $($constant:literal),*) => {
        $(if $constant < $dimension {
            let $component: usize = $constant;
            $block
        })*
    };
}
