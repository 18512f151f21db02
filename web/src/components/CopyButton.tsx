/** Copies a text to the clipboard, and says so for a moment. */
import { useEffect, useState } from "react";

import { copyText } from "../ui/copy-text";
import { Tool } from "../ui/Tool";

const COPIED_MS = 1500;

interface CopyButtonProps {
  text: string;
  label: string;
  copied: string;
  testId: string;
}

export function CopyButton({ text, label, copied, testId }: CopyButtonProps) {
  const [isCopied, setCopied] = useState(false);
  useEffect(() => {
    if (!isCopied) return;
    const timer = setTimeout(() => setCopied(false), COPIED_MS);
    return () => clearTimeout(timer);
  }, [isCopied]);
  return (
    <Tool
      small
      icon={isCopied ? "check" : "copy"}
      label={isCopied ? copied : label}
      testId={testId}
      onClick={() => {
        void copyText(text).then(setCopied);
      }}
    />
  );
}
