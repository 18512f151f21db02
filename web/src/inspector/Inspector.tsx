/** What can be set on the selected part. */
export function Inspector() {
  return <div className="inspector" />;
}
