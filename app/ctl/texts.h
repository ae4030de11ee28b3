#pragma once

#include <QCoreApplication>

namespace lds::ctl {

/// The translation context of everything ldsctl says to a person.
struct Texts {
    Q_DECLARE_TR_FUNCTIONS(lds::ctl::Texts)
};

} // namespace lds::ctl
