/** How small and how large the graph can be shown. */
export const LEAST_ZOOM = 0.1;
export const MOST_ZOOM = 2;
